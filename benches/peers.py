"""What other programs need for one impact, as a table of times for `carom study --peers`.

    pip install sympy python-flint numpy pymunk        whichever you like; what is missing is left out, and said
    python3 benches/peers.py > peers.csv
    carom study --peers peers.csv

Scenes are those of the study: `oblique` is any line of centres with whole numbers and a fraction for e, `letters` has the
masses m and km and the letter e. Every program is given its numbers ready made and is timed for the solving alone, the
shortest of some turns. The column `ratio` is the time as a multiple of plain Python floats in the same run. Errors are
measured against Python's fractions, as a part of the largest speed. Talk goes to stderr.
"""

import random
import sys
import time
from fractions import Fraction
from math import cos, gcd, hypot, radians, sin


def say(words):
    print(words, file=sys.stderr)


def best(work, count, turns=7):
    """Nanoseconds for one of `count` solutions that `work()` does."""
    shortest = float("inf")
    for _ in range(turns):
        begun = time.perf_counter_ns()
        work()
        shortest = min(shortest, time.perf_counter_ns() - begun)
    return shortest / count


def deal(number, generator=random.Random(5)):
    """Impacts as tuples: masses, velocities, line of centres, e."""
    scenes = []
    while len(scenes) < number:
        whole = generator.randint
        m_a, m_b = whole(1, 9), whole(1, 9)
        a, b = (whole(-9, 9), whole(-9, 9)), (whole(-9, 9), whole(-9, 9))
        line = (whole(-4, 4), whole(-4, 4))
        parts = whole(2, 10)
        e = Fraction(whole(1, parts), parts)
        if (a[0] - b[0]) * line[0] + (a[1] - b[1]) * line[1] > 0:
            scenes.append((m_a, m_b, *a, *b, *line, e))
    return scenes


def formula(m_a, m_b, a_x, a_y, b_x, b_y, x, y, e):
    """The impulse along the line of centres, for any kind of number."""
    g = (1 + e) * ((a_x - b_x) * x + (a_y - b_y) * y) / ((m_a + m_b) * (x * x + y * y))
    return a_x - m_b * g * x, a_y - m_b * g * y, b_x + m_a * g * x, b_y + m_a * g * y


def worst(found, scenes):
    """The largest error of a component as a part of the largest speed."""
    largest = 0.0
    for after, scene in zip(found, scenes):
        right = formula(*[Fraction(number) for number in scene])
        speed = max(hypot(scene[2], scene[3]), hypot(scene[4], scene[5]))
        largest = max([largest] + [abs(float(Fraction(x) - y)) / speed for x, y in zip(after, right)])
    return largest


rows = []
plain = None


def row(name, scene, nanoseconds, error, kind="peer", steps=""):
    error = "" if error is None else f"{error:.2e}"
    rows.append(f"{name},{kind},{scene},{steps},{nanoseconds:.3f},{nanoseconds / plain:.3f},{error}")
    say(f"  {name}: {nanoseconds:.0f} ns")


scenes = deal(256)


def with_formula(name, convert, number):
    """Times the formula above in some kind of number."""
    ready = [[convert(value) for value in scene] for scene in scenes[:number]]
    nanoseconds = best(lambda: [formula(*scene) for scene in ready], number)
    return nanoseconds, [formula(*scene) for scene in ready]


plain, found = with_formula("python floats", float, 256)
row("python floats", "oblique", plain, worst(found, scenes))
nanoseconds, found = with_formula("python fractions", Fraction, 256)
row("python fractions", "oblique", nanoseconds, 0.0)

try:
    import numpy

    columns = [numpy.array([float(scene[place]) for scene in scenes]) for place in range(9)]
    nanoseconds = best(lambda: formula(*columns), 256, 50)
    found = list(zip(*[column.tolist() for column in formula(*columns)]))
    row("numpy columns", "oblique", nanoseconds, worst(found, scenes))

    def matrices():
        """Momentum, restitution and what is across, as four equations with the components after."""
        left, right = numpy.zeros((256, 4, 4)), numpy.zeros((256, 4, 1))
        for place, (m_a, m_b, a_x, a_y, b_x, b_y, x, y, e) in enumerate(scenes):
            left[place] = [[m_a * x, m_a * y, m_b * x, m_b * y], [-x, -y, x, y], [-y, x, 0, 0], [0, 0, -y, x]]
            along_a, along_b = a_x * x + a_y * y, b_x * x + b_y * y
            right[place, :, 0] = [
                m_a * along_a + m_b * along_b, float(e) * (along_a - along_b), a_y * x - a_x * y, b_y * x - b_x * y
            ]
        return left, right

    left, right = matrices()
    nanoseconds = best(lambda: numpy.linalg.solve(left, right), 256, 50)
    found = numpy.linalg.solve(left, right)[:, :, 0].tolist()
    row("numpy.linalg columns", "oblique", nanoseconds, worst(found, scenes))
    nanoseconds = best(lambda: [numpy.linalg.solve(a, b) for a, b in zip(left, right)], 256)
    row("numpy.linalg one by one", "oblique", nanoseconds, worst(found, scenes))
except ImportError:
    say("skipped: numpy is not installed")

try:
    import flint

    convert = lambda value: flint.fmpq(Fraction(value).numerator, Fraction(value).denominator)
    nanoseconds, found = with_formula("python-flint", convert, 256)
    exact = [[Fraction(int(value.p), int(value.q)) for value in after] for after in found]
    assert worst(exact, scenes) == 0
    row("python-flint fmpq", "oblique", nanoseconds, 0.0)
except ImportError:
    say("skipped: python-flint is not installed")

try:
    import sympy
    from sympy.core.cache import clear_cache

    v_a, v_b = sympy.symbols("v_a v_b")
    some = scenes[:8]

    def solved(m_a, m_b, a_x, a_y, b_x, b_y, x, y, e):
        """The two equations along the line of centres, solved as on paper."""
        along_a, along_b = a_x * x + a_y * y, b_x * x + b_y * y
        momentum = m_a * v_a + m_b * v_b - (m_a * along_a + m_b * along_b)
        restitution = v_b - v_a - e * (along_a - along_b)
        return sympy.solve([momentum, restitution], [v_a, v_b])

    rational = [[sympy.Rational(str(value)) for value in scene] for scene in some]

    def numbers():
        clear_cache()
        return [solved(*scene) for scene in rational]

    row("sympy solve", "oblique", best(numbers, 8, 3), 0.0)
    m, k = sympy.symbols("m k", positive=True)
    e = sympy.symbols("e", nonnegative=True)

    def letters():
        clear_cache()
        return [solved(m, k * m, *scene[2:8], e) for scene in rational]

    row("sympy solve letters", "letters", best(letters, 8, 3), 0.0)
except ImportError:
    say("skipped: sympy is not installed")

try:
    import pymunk

    def engine(dt, phase):
        """4 kg at 4 m/s strikes 2 kg at rest, 30 degrees to the line of centres, e = 1/3; radii 1/2."""
        space = pymunk.Space()
        space.iterations = 10
        bodies = []
        angle, start = radians(30), 1.0 + 4 * dt * phase
        for mass, place, velocity in [
            (4.0, (-cos(angle) * 1.0 - start, -sin(angle)), (4.0, 0.0)), (2.0, (0.0, 0.0), (0.0, 0.0))
        ]:
            body = pymunk.Body(mass, float("inf"))
            body.position, body.velocity = place, velocity
            shape = pymunk.Circle(body, 0.5)
            shape.elasticity, shape.friction = (1 / 3) ** 0.5, 0.0
            space.add(body, shape)
            bodies.append(body)
        steps = int(2 * start / 4.0 / dt) + 4
        begun = time.perf_counter_ns()
        for _ in range(steps):
            space.step(dt)
        return time.perf_counter_ns() - begun, bodies

    # Along the line of centres u = 4 cos 30, across it 2; the line makes an angle of 30 degrees with the path.
    along, across = 4 * cos(radians(30)), 4 * sin(radians(30))
    after_a, after_b = along * (4 - 2 / 3) / 6, along * (4 + 4 / 3) / 6
    c, s = cos(radians(30)), sin(radians(30))
    right = [(after_a * c + across * s, after_a * s - across * c), (after_b * c, after_b * s)]
    for rate in (60, 240, 1000, 10000):
        off, taken = 0.0, float("inf")
        for phase in range(16):
            nanoseconds, bodies = engine(1 / rate, phase / 16)
            taken = min(taken, nanoseconds)
            for body, velocity in zip(bodies, right):
                off = max([off] + [abs(x - y) / 4 for x, y in zip(body.velocity, velocity)])
        row("pymunk", "oblique", taken, off, steps=rate)
except ImportError:
    say("skipped: pymunk is not installed")

print("name,kind,scene,steps,nanoseconds,ratio,error")
print("\n".join(rows))
