"""One row of a table judged: who, which group, which test, which marks. Nothing is guessed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.cells import TableError, TableRow
from sim.classroom.tables.layout import Column, Layout, form_told, norm
from sim.classroom.tables.marks import is_nothing, mark, shown
from sim.classroom.tables.taken import ALONE, Taken
from sim.classroom.tables.words import ANONYMOUS, UNFINISHED
from sim.scene.said import reason_of, said, template

LONGEST_NAME = 120
LONGEST_OPTION = 20


class RowReader:
    """Reads rows by a layout. `keys`: right answers by item, from rows KEY."""

    def __init__(
        self, layout: Layout, heads: TableRow, keys: Sequence[TableRow], letters: bool, form: str
    ) -> None:
        self.layout = layout
        self.heads = heads
        self.letters = letters
        self.form = form
        self.keys: Mapping[str, tuple[str, ...]] = {
            column.name: tuple(part.strip().casefold() for part in cell.split("|"))
            for row in keys
            for column in layout.items
            if not is_nothing(cell := row.cell(column.place))
        }

    def taken(self, table: str, row: TableRow) -> Iterator[Taken]:
        """The tests that this student took; raises `TableError`."""
        layout = self.layout
        if len(row.cells) > len(self.heads.cells) and any(row.cells[len(self.heads.cells) :]):
            raise TableError(said(
                "{cells} cells under {headings} headings: is a comma in a cell without quotation "
                "marks?", cells=f"{len(row.cells)}", headings=f"{len(self.heads.cells)}",
            ))  # fmt: skip
        if layout.needs and not any(row.cell(k) for k in layout.needs):
            return  # what an export adds below: the average of all
        if layout.state is not None and norm(row.cell(layout.state)) in UNFINISHED:
            raise TableError("this attempt was not handed in")
        student = self._student(row)
        columns = layout.items or layout.totals
        for form in dict.fromkeys(column.form for column in columns):
            mine = [column for column in columns if column.form == form]
            made = self._one(row, mine, student, self.form or form or self._form(row), table)
            if made:
                yield made

    def _student(self, row: TableRow) -> str:
        for places in self.layout.student:
            words = [cell for k in places if not is_nothing(cell := row.cell(k))]
            name = " ".join(words)
            if name and norm(name) not in ANONYMOUS:
                return _short(name, template("the name of the student"))
        return ""

    def _form(self, row: TableRow) -> str:
        if self.layout.time is None:
            return ALONE
        text = row.cell(self.layout.time)
        form = form_told(text)
        if not form:
            raise TableError(said("“{cell}” is none of pre, post, later", cell=shown(text)))
        return form

    def _one(
        self, row: TableRow, columns: Sequence[Column], student: str, form: str, table: str
    ) -> Taken | None:
        """One test; None where nothing at all was answered: it was not taken."""
        group, klass = (
            _short(row.cell(k), what) if k is not None else ""
            for k, what in (
                (self.layout.group, template("the group")),
                (self.layout.klass, template("the class")),
            )
        )
        items: dict[str, Exact | None] = {}
        most: dict[str, Exact] = {}
        chosen: dict[str, str] = {}
        total: Exact | None = None
        of: Exact | None = None
        for column in columns:
            cell = row.cell(column.place)
            if not self.layout.items:
                total, told = _mark(cell, column, self.heads.cells[column.place])
                of = told
            elif self.letters:
                items[column.name], chosen[column.name] = self._answer(cell, column.name)
                most[column.name] = int(column.name in self.keys)
            else:
                items[column.name], told = _mark(cell, column, column.name)
                if told is not None:
                    most[column.name] = told
        if total is None and not any(chosen.values()) and all(m is None for m in items.values()):
            return None
        return Taken(
            table=table, line=row.line, student=student, group=group, klass=klass, form=form,
            items=items, most=most, chosen={k: v for k, v in chosen.items() if v}, total=total,
            of=of,
        )  # fmt: skip

    def _answer(self, cell: str, name: str) -> tuple[Exact | None, str]:
        """The mark, 0 or 1, and the option; without a key for the item there is no mark."""
        if is_nothing(cell):
            return None, ""
        if len(cell) > LONGEST_OPTION:
            raise TableError(_of(name, said("“{cell}” is no option", cell=shown(cell))))
        right = self.keys.get(name)
        option = cell.upper() if len(cell) == 1 else cell
        return (None if right is None else int(cell.casefold() in right)), option


def _mark(cell: str, column: Column, name: str) -> tuple[Exact | None, Exact | None]:
    try:
        value, told = mark(cell)
    except TableError as error:
        raise TableError(_of(name, reason_of(error))) from None
    most = told if told is not None else column.of
    if value is not None and column.of is not None and value > column.of:
        raise TableError(_of(name, said("“{cell}” is more than the most marks", cell=shown(cell))))
    return value, most


def _of(name: str, reason: str) -> str:
    """What is wrong in a column."""
    return said("{name}: {reason}", name=shown(name), reason=reason)


def _short(text: str, what: str) -> str:
    if len(text) > LONGEST_NAME:
        raise TableError(said("{what} has {n} characters: at most {most}", what=what,
                              n=f"{len(text)}", most=f"{LONGEST_NAME}"))  # fmt: skip
    return "".join(c for c in text if c.isprintable())
