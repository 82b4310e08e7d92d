"""Tables of marks as Moodle, Google Forms and Microsoft Forms export them."""

from __future__ import annotations

from tests.classroom.given.tables import csv

WIDE = csv(("student", "group", "pre", "post"),
           [[f"s{k}", "ab"[k % 2], k % 5, k % 7] for k in range(14)])  # fmt: skip
MOODLE = """\
Surname,First name,ID number,Email address,State,Started on,Time taken,Grade/10.00,Q. 1 /5.00,\
Q. 2 /5.00
Fox,Blue,,fox@school.example,Finished,1 March 2026,3 mins,7.50,5.00,2.50
Owl,Red,,owl@school.example,Finished,1 March 2026,3 mins,2.50,-,2.50
Elk,Old,,elk@school.example,In progress,1 March 2026,-,-,-,-
Hare,Shy,,hare@school.example,Finished,1 March 2026,3 mins,-,-,-
Overall average,,,,,,,5.00,2.50,2.50
"""
MOODLE_GERMAN = """\
Nachname;Vorname;E-Mail-Adresse;Status;Begonnen am;Bewertung/10,00;F 1 /5,00;F 2 /5,00
Fox;Blue;fox@school.example;Beendet;1. März;7,50;5,00;2,50
Owl;Red;owl@school.example;Beendet;1. März;2,50;-;2,50
Gesamtdurchschnitt;;;;;5,00;2,50;2,50
"""
GOOGLE = """\
Timestamp,Email Address,Score,Your code word,Which force?,Class
2026/03/01 9:00:00,fox@school.example,7 / 10,BLUE-FOX,"The first, of course",7a
2026/03/01 9:01:00,owl@school.example,2 / 10,RED-OWL,none,7a
"""
GOOGLE_ITEMS = """\
"Timestamp","Total score","Code word","Which force?","Which force? [Score]",\
"Which force? [Feedback]"
"2026/03/01","1.00 / 1","BLUE-FOX","first","1.00 / 1",""
"2026/03/01","0.00 / 1","RED-OWL","none","0.00 / 1",""
"""
MICROSOFT = """\
ID,Start time,Completion time,Email,Name,Total points,Quiz feedback,Code word,\
Points - Code word,Which force?,Points - Which force?,Why?,Points - Why?
1,x,y,anonymous,,4,,BLUE-FOX,,first,1,so,3
2,x,y,anonymous,,1,,RED-OWL,,none,0,so,1
"""
