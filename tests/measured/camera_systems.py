"""What other camera systems than Qualisys' export of a motion."""

from __future__ import annotations

RATE = 250  # Hz, of `motion_capture`
Frames = list[tuple[str, ...]]


def frames_of(text: str) -> Frames:
    """X Y Z of both markers in mm, as they stand in Qualisys' file."""
    return [tuple(line.split("\t")) for line in text.splitlines() if line[:1].isdigit()]


def optitrack(frames: Frames, *, bodies: bool = False) -> str:
    """Motive's CSV in metres; `bodies`: rigid bodies with a turn, and a marker on the floor."""
    kind = "Rigid Body" if bodies else "Marker"
    turn, four = (["Rotation"] * 4, "XYZW") if bodies else ([], "")
    each = len(turn) + 3
    kinds, names = [kind] * 2 * each, [f"cart {k}" for k in (1, 2) for _ in range(each)]
    what, axes = [*turn, *["Position"] * 3] * 2, [*four, *"XYZ"] * 2
    if bodies:
        kinds, names = [*kinds, *["Marker"] * 3], [*names, *["Unlabeled 1004"] * 3]
        what, axes = [*what, *["Position"] * 3], [*axes, *"XYZ"]
    lines = [
        f"Format Version,1.23,Take Name,carts,Take Notes,,Capture Frame Rate,{RATE}.000000,"
        f"Export Frame Rate,{RATE}.000000,Rotation Type,Quaternion,Length Units,Meters",
        "",
        *(",," + ",".join(row) for row in (kinds, names, ["A1"] * len(kinds), what)),
        "Frame,Time (Seconds)," + ",".join(axes),
    ]
    for k, frame in enumerate(frames):
        cells = [f"{float(cell) / 1000:.6f}" if float(cell) else "" for cell in frame]
        rest = ["0.1", "0.2", "0.3", "0.9"] if bodies else []
        row = [*rest, *cells[:3], *rest, *cells[3:], *(["1.5", "0.2", "0.1"] if bodies else [])]
        lines.append(f"{k},{k / RATE:.6f}," + ",".join(row))
    return "\n".join(lines) + "\n"


def vicon(frames: Frames) -> str:
    """Nexus' CSV, with forces of a plate before the markers."""
    lines = ["Devices", "1000", ",,Plate", "Frame,Sub Frame,Fx", ",,N", "1,0,0.5", "",
             "Trajectories", str(RATE), ",,carts:A,,,carts:B,,", "Frame,Sub Frame,X,Y,Z,X,Y,Z",
             ",,mm,mm,mm,mm,mm,mm"]  # fmt: skip
    lines += [
        f"{k},0," + ",".join(cell if float(cell) else "" for cell in frame)
        for k, frame in enumerate(frames, 101)
    ]
    return "\n".join([*lines, "", "Model Outputs", "1000"]) + "\n"
