"""The headings of columns in English, German, Malay, Chinese and Tamil, as people write them."""

from __future__ import annotations


def words(text: str) -> frozenset[str]:
    """Headings between bars."""
    return frozenset(word.strip() for word in text.replace("\n", " ").split("|"))


STUDENT = words("""
    student | students | student id | studentid | id | student code | code | code word | codeword |
    pseudonym | name | student name | participant | schüler | schülerin | codewort | kode | murid |
    pelajar | nama | 学生 | 学号 | 姓名 | மாணவர் | பெயர்
""")
GROUP = words("group | condition | treatment | gruppe | kumpulan | 组 | 组别 | 小组 | குழு")
CLASS = words("class | section | classroom | klasse | kelas | 班 | 班级 | வகுப்பு")
TIME = words("""
    time | occasion | when | wave | phase | prepost | pre/post | zeitpunkt | masa | 时间 | 测试 |
    நேரம்
""")
TOTAL = words("""
    total | total score | total marks | score | scores | mark | marks | sum | points |
    total points | grade | punkte | gesamt | summe | jumlah | markah | skor | 总分 | 分数 | மொத்தம் |
    மதிப்பெண்
""")
MARK = TOTAL | {"answer"}
ITEM = words("item | question | item id | frage | aufgabe | soalan | 题 | 题目 | கேள்வி")
OTHER = words("""
    age | gender | sex | year | date | school | teacher | email | e-mail | email address | no |
    no. | nr | nr. | row | line | timestamp | comment | comments | remark | remarks | alter |
    geschlecht | jahr | datum | schule | lehrer | umur | jantina | tarikh | 年龄 | 性别 | 日期 |
    வயது | பாலினம்
""")
TIMES = {
    "pre": words("""
        pre | pretest | pre-test | pre test | before | vor | vorher | vortest | pra | praujian |
        sebelum | 前 | 前测 | முன் | முன்தேர்வு
    """),
    "post": words("""
        post | posttest | post-test | post test | after | nach | nachher | nachtest | pasca |
        pascaujian | selepas | 后 | 后测 | பின் | பின்தேர்வு
    """),
    "delayed": words("""
        later | delayed | retention | follow-up | followup | später | kemudian | 延迟 | 延迟测 |
        பின்னர்
    """),
}
KEY = words("key | answer key | schlüssel | lösung | kunci | 答案 | விடை")
MOST = words("max | maximum | out of | höchstens | maksimum | 满分")
NAMES_TOO = words("max | key")
"""Of these two what may be the name of a student: such a row is known by its capitals."""
SUMS = words("total | sum | grand total | gesamt | summe | jumlah | 总分 | 总计 | 合计 | மொத்தம்")
"""How rows below a table call themselves that add up the others, and those with other figures."""
FIGURES = words("""
    mean | class mean | average | class average | avg | avg. | median | standard deviation |
    std dev | stdev | std. dev. | minimum | ø |
    mittelwert | mittel | durchschnitt | standardabweichung | purata | sisihan piawai | 平均 |
    平均分 | 平均值 | 标准差 | சராசரி
""")
NAMES_OR_FIGURES = words("min | sd")
"""The same, where another row of figures or sums stands in the table: somebody may be called so."""
UNFINISHED = words("""
    in progress | never submitted | overdue | in bearbeitung | nie abgegeben | überfällig |
    sedang dijalankan | 进行中 | 从未提交
""")
ANONYMOUS = words("anonymous | anonym | tanpa nama | 匿名")
