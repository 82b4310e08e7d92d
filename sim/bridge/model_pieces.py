"""The pieces of the plain program that `model_text` puts together."""

NEARLY = "It goes in small steps of time, so it is nearly right."

TOO_LONG = """\
Do not trust its numbers: these values ask for steps of {wanted} s. Its own are {dt} s,
# or it would take too long. Make until smaller, and then dt."""

HEAD = """\
# {title}: a model in plain Python. It needs nothing else.
# {near}
# The lesson computes the same run exactly.
from math import copysign, sqrt

names = {names}
mass = {mass}  # kg
x = {x}  # m, the middle of each cart; + is to the right
v = {v}  # m/s
half = {half}  # m, half the length of each cart
end = {end}  # m, where the right wall stands
until, dt = {until}, {dt}  # s

# Who may touch whom: left, right (None is a wall), law, stiffness k, bounciness e, damping c
contacts = [
{contacts}]
deepest = [0.0] * len(contacts)  # m, how far each pair was pressed in
stuck = set()  # contacts that hold together
t = 0.0
"""

PLACES = '''

def gap(left, right):
    """Room between two bodies in m; below 0 they are pressed into each other."""
    start = 0.0 if left is None else x[left] + half[left]
    stop = end if right is None else x[right] - half[right]
    return stop - start


def approach(left, right):
    """How fast the gap closes, in m/s."""
    return (0.0 if left is None else v[left]) - (0.0 if right is None else v[right])


def push_apart(force, left, right, size):
    """The third law: one force, on both, away from each other."""
    if left is not None:
        force[left] -= size
    if right is not None:
        force[right] += size

'''

KICK = '''
def light(left, right):
    """1/m of both together: what an impulse does to the speed between them."""
    return sum(1 / sum(mass[i] for i in team(one)) for one in (left, right) if free(one))


def kick(left, right, impulse):
    """An impulse in N s that pushes both apart at once."""
    for one, way in ((left, -1), (right, 1)):
        if free(one):
            for i in team(one):
                v[i] += way * impulse / sum(mass[j] for j in team(one))

'''

ALONE = '''
def team(one):
    """The carts that move as one with this cart."""
    return [one]


def free(one):
    return one is not None

'''

GROUPS = '''
def team(one):
    """The carts that move as one with this cart."""
    found = [one]
    for _ in stuck:
        for k in stuck:
            left, right = contacts[k][:2]
            if left in found and right is not None and right not in found:
                found.append(right)
            if right in found and left is not None and left not in found:
                found.append(left)
    return found


def free(one):
    """A wall does not move, and what sticks to it does not either."""
    walls = [k for k in stuck if None in contacts[k][:2]]
    held = {i for k in walls for i in contacts[k][:2] if i is not None}
    return one is not None and not held & set(team(one))

'''

STEP = '''
def step():
    """One small step: forces, then velocities, then positions."""
    global t
    force = [0.0] * len(names)
'''

CONTACTS = """\
    for k, (left, right, law, stiffness, e, c) in enumerate(contacts):
        d, s = -gap(left, right), approach(left, right)
        deepest[k] = max(d, deepest[k]) if d > 0 else 0.0
        if d <= 0 or k in stuck or stiffness == 0:
            continue
"""

OF_TEAMS = """\
        alone = sum(1 / mass[i] for i in (left, right) if i is not None)
        if light(left, right):  # a damper is that of all that moves as one
            c *= sqrt(alone / light(left, right))
"""

PUSH_APART = """\
        push_apart(force, left, right, size)
"""

MOVE_ALONE = """\
    for i in range(len(names)):
        v[i] += force[i] / mass[i] * dt
        x[i] += v[i] * dt
    t += dt
"""

MOVE = """\
    for i in range(len(names)):
        if free(i):
            v[i] += sum(force[j] for j in team(i)) / sum(mass[j] for j in team(i)) * dt
    for i in range(len(names)):
        x[i] += (v[i] if free(i) else 0.0) * dt
    t += dt
"""

IMPACTS = """\
    for _ in range(50):  # one impact may lead to the next
        for k, (left, right, law, stiffness, e, c) in enumerate(contacts):
            s = approach(left, right)
            if stiffness == 0 and k not in stuck and gap(left, right) <= 0 and s > 0:
                kick(left, right, (1 + e) * s / light(left, right))
                if law in JOINING:
                    stuck.add(k)
"""

RUN = """

print("t in s", *(f"{name}: x in m, v in m/s" for name in names), sep=" | ")
shown = 0
while t < until - dt / 2:
    if t >= shown * until / 20:
        print(f"{t:.3f}", *(f"{x[i]:.4f}, {v[i]:+.4f}" for i in range(len(names))), sep=" | ")
        shown += 1
    step()
print(f"{t:.3f}", *(f"{x[i]:.4f}, {v[i]:+.4f}" for i in range(len(names))), sep=" | ")
"""
