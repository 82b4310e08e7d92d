"""The headings of columns as people write them: in English, French, German, Malay, Spanish, Chinese
in both writings, and Tamil.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

_ACCENTS = re.compile("[\u0300-\u036f]")  # of Latin letters; the signs of Tamil are none of these


def words(text: str) -> frozenset[str]:
    """Headings between bars, with their accents and as they are typed in haste: apres."""
    return frozenset(
        one for word in " ".join(text.split()).split("|") for one in _typed(word.strip())
    )


def _typed(word: str) -> Iterator[str]:
    yield word
    yield unicodedata.normalize("NFC", _ACCENTS.sub("", unicodedata.normalize("NFD", word)))


ID_NUMBER = words("id number | id-nummer | nombor id | numéro d'identification | número de id")
NUMBER = ID_NUMBER | words("""
    id | index number | index no | index no. | register number | register no | register no. |
    roll number | roll no | roll no. | student number | candidate number | matric number |
    matric no | matric no. | admission number | matrikelnummer | schülernummer |
    no. pengenalan | numéro d'étudiant | número de matrícula
""")
"""Of a person, but it may count the answers only: who has a name goes by that."""
STUDENT = NUMBER | words("""
    student | students | student id | studentid | student code | code | code word | codeword |
    username | pseudonym | name | full name | student name | participant | schüler | schülerin |
    codewort | kode | murid | pelajar | nama | élève | étudiant | étudiante | nom | nom de famille |
    nom et prénom | nom complet | prénom | identifiant | pseudonyme | mot de code |
    participante | estudiante | alumno | alumna | alumno/a | nombre | nombre y apellidos |
    apellidos y nombre | nombre completo | apellido | apellidos | apellido(s) | código |
    seudónimo |
    palabra clave | 学生 | 学生姓名 | 学号 | 姓名 |
    學生 | 學生姓名 | 學號 | மாணவர் | பெயர்
""")
FAMILY = words("""
    last name | lastname | surname | family name | nachname | familienname | zuname | nom |
    nom de famille | apellido | apellidos | apellido(s) | nama keluarga | 姓 | 姓氏 |
    குடும்பப்பெயர்
""")
GIVEN = words("""
    first name | firstname | given name | forename | vorname | rufname | prénom | nombre |
    nombre(s) | nama pertama | 名 | 名字 | முதல் பெயர்
""")
"""One student is named by both: of either alone there may be two in a class."""
WHO = STUDENT | FAMILY | GIVEN
GROUP = words("""
    group | condition | treatment | gruppe | kumpulan | groupe | grupo | condición | 组 | 组别 |
    小组 | 組 | 組別 | 小組 | குழு
""")
CLASS = words("""
    class | section | classroom | klasse | kelas | classe | clase | curso | sección | 班 | 班级 |
    班級 | வகுப்பு
""")
TIME = words("""
    time | occasion | when | wave | phase | prepost | pre/post | zeitpunkt | masa | moment |
    momento | quand | cuándo | fase | 时间 | 测试 | 時間 | 測試 |
    நேரம்
""")
TOTAL = words("""
    total | total score | total marks | score | scores | mark | marks | sum | points |
    total points | grade | punkte | gesamt | summe | jumlah | markah | skor | somme | note totale |
    note finale | total des points | suma | puntos | puntuación | puntaje | calificación |
    nota total | nota final | 总分 | 分数 | 總分 | 分數 | மொத்தம் |
    மதிப்பெண்
""")
MARK = TOTAL | words("answer | réponse | respuesta")
NOTE = words("note | nota")
"""Marks in French and Spanish, remarks in English and Malay: marks where nothing else is. No total:
alone, such a column of numbers is read as one question."""
ITEM = words("""
    item | question | item id | frage | aufgabe | soalan | exercice | pregunta | ítem | ejercicio |
    题 | 题目 | 題 | 題目 | கேள்வி
""")
OTHER = words("""
    age | gender | sex | year | date | school | institution | department | phone | teacher |
    email | e-mail | email address | no | no. | nr | nr. | row | line | timestamp | comment |
    comments | remark | remarks | alter | geschlecht | jahr | datum | schule | lehrer | umur |
    jantina | tarikh | âge | sexe |
    année | école | enseignant | enseignante | professeur | courriel | adresse de courriel |
    remarque | remarques | commentaire | commentaires | n° | numéro | edad | sexo | género | año |
    fecha | escuela | profesor | profesora | correo | correo electrónico | comentario |
    comentarios | observaciones | número | 年龄 | 性别 | 日期 |
    座号 | 年齡 | 性別 | 座號 |
    வயது | பாலினம்
""")
TIMES = {
    "pre": words("""
        pre | pretest | pre-test | pre test | before | vor | vorher | vortest | pra | praujian |
        sebelum | avant | pré-test | prétest | antes | pre-prueba | preprueba | 前 | 前测 | 前測 |
        முன் | முன்தேர்வு
    """),
    "post": words("""
        post | posttest | post-test | post test | after | nach | nachher | nachtest | pasca |
        pascaujian | selepas | après | después | postest | post-prueba | postprueba |
        后 | 后测 | 後 | 後測 | பின் | பின்தேர்வு
    """),
    "delayed": words("""
        later | delayed | retention | follow-up | followup | später | kemudian | plus tard |
        différé | más tarde | diferido | 延迟 | 延迟测 | 延遲 | 延遲測 |
        பின்னர்
    """),
}
KEY = words("key | answer key | schlüssel | lösung | kunci | clé | corrigé | clave | 答案 | விடை")
MOST = words(
    "max | maximum | out of | points possible | höchstens | maksimum | máximo | 满分 | 滿分"
)
NAMES_TOO = words("max | key | clave")
"""Of these what may be the name of a student: such a row is known by its capitals."""
SUMS = words("""
    total | sum | grand total | gesamt | summe | jumlah | somme | suma | 总分 | 总计 | 合计 |
    總分 | 總計 | 合計 |
    மொத்தம்
""")
"""How rows below a table call themselves that add up the others, and those with other figures."""
FIGURES = words("""
    mean | class mean | average | class average | avg | avg. | median | standard deviation |
    std dev | stdev | std. dev. | minimum | ø |
    mittelwert | mittel | durchschnitt | standardabweichung | purata | sisihan piawai | moyenne |
    médiane | écart-type | écart type | media | promedio | mediana | desviación estándar |
    desviación típica | mínimo | 平均 |
    平均分 | 平均值 | 标准差 | 標準差 | சராசரி
""")
NAMES_OR_FIGURES = words("min | sd")
"""The same, where another row of figures or sums stands in the table: somebody may be called so."""
UNFINISHED = words("""
    in progress | never submitted | overdue | in bearbeitung | nie abgegeben | überfällig |
    sedang dijalankan | en cours | jamais remis | en curso | nunca enviado | 进行中 | 从未提交
""")
ANONYMOUS = words("anonymous | anonym | tanpa nama | anonyme | anónimo | 匿名")
