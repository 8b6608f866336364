"""Solves random impacts by numbers alone, to fifty figures, and compares all that Carom says of them.

usage: python3 oracle.py PROGRAM [COUNT] [SEED]

PROGRAM is the example `solve_stream`. The oracle works with vectors and the reduced mass and shares no formula with
the program. Letters are given numbers, and the program's formulas are evaluated at them.
"""
import json, random, re, subprocess, sys, threading
from fractions import Fraction as F
import mpmath as mp
import sympy as sp

mp.mp.dps = 50
rnd = random.Random(0)
deg = mp.pi / 180


def number(text, letters=None):
    """The value of an expression of the exchange format, by Python's own reader."""
    names = {"sqrt": mp.sqrt, "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "asin": mp.asin, "acos": mp.acos,
             "atan": mp.atan, "abs": abs, "pi": mp.pi, "deg": deg, "N": mp.mpf}
    names.update(letters or {})
    text = re.sub(r"(?<![\w.])(\d+(?:\.\d+)?)", r"N('\1')", text.replace("^", "**"))
    return mp.mpf(eval(text, {"__builtins__": {}}, names))


def dot(a, b): return a[0] * b[0] + a[1] * b[1]
def cross(a, b): return a[0] * b[1] - a[1] * b[0]
def plus(a, b): return (a[0] + b[0], a[1] + b[1])
def minus(a, b): return (a[0] - b[0], a[1] - b[1])
def times(k, a): return (k * a[0], k * a[1])
def size(a): return mp.sqrt(dot(a, a))
def zero(x): return abs(x) < mp.mpf(10) ** -40


def angle(v):
    y, x = (mp.mpf(0) if zero(c) else c for c in (v[1], v[0]))
    return mp.atan2(y, x) / deg


def quantities(m, u, n, e):
    """Every quantity of the exchange format, from masses, velocities before, the unit vector n and e."""
    n = times(1 / size(n), n)
    mA, mB = m
    approach = dot(minus(u[0], u[1]), n)
    J = mA * mB / (mA + mB) * (1 + e) * approach
    v = (minus(u[0], times(J / mA, n)), plus(u[1], times(J / mB, n)))
    t = (-n[1], n[0])
    q = {}
    for i, X in enumerate("AB"):
        q[X + ".mass"] = m[i]
        for w, name in ((u[i], "before"), (v[i], "after")):
            p = f"{X}.{name}."
            along, across = dot(w, n), dot(w, t)
            q[p + "x"], q[p + "y"], q[p + "n"], q[p + "t"] = w[0], w[1], along, across
            q[p + "speed"], q[p + "ke"] = size(w), m[i] * dot(w, w) / 2
            q[p + "px"], q[p + "py"] = m[i] * w[0], m[i] * w[1]
            if not zero(size(w)):
                q[p + "angle_to_loc_deg"] = angle((abs(along), abs(across)))
                q[p + "angle_from_n_deg"] = angle((along, across))
                q[p + "angle_from_i_deg"] = angle(w)
            if not zero(along):
                q[p + "tan_to_loc"] = abs(across / along)
                q[p + "t_over_n"] = across / along
        c, d = cross(u[i], v[i]), dot(u[i], v[i])
        p = X + "."
        q[p + "deflection_cross"], q[p + "deflection_dot"] = c, d
        if not zero(size(u[i])) and not zero(size(v[i])):
            q[p + "deflection_deg"] = angle((d, abs(c)))
            q[p + "deflection_signed_deg"] = angle((d, c))
            if not zero(d):
                q[p + "tan_deflection"] = c / d
        I = times(m[i], minus(v[i], u[i]))
        q[p + "impulse.x"], q[p + "impulse.y"] = I
        q[p + "impulse.n"], q[p + "impulse.t"] = dot(I, n), mp.mpf(0)
        q[p + "ke_lost"] = m[i] * (dot(u[i], u[i]) - dot(v[i], v[i])) / 2
    q["impulse.magnitude"] = J
    q["approach"], q["separation"], q["e"] = approach, dot(minus(v[1], v[0]), n), e
    q["mass_ratio"] = mB / mA
    q["n.x"], q["n.y"], q["t.x"], q["t.y"] = n[0], n[1], t[0], t[1]
    q["ke.before"] = sum(m[i] * dot(u[i], u[i]) for i in (0, 1)) / 2
    q["ke.after"] = sum(m[i] * dot(v[i], v[i]) for i in (0, 1)) / 2
    q["ke.lost"] = q["ke.before"] - q["ke.after"]
    q["ke.fraction_lost"] = q["ke.lost"] / q["ke.before"]
    total = plus(times(mA, u[0]), times(mB, u[1]))
    q["momentum.x"], q["momentum.y"] = total
    for w, name in ((u, "before"), (v, "after")):
        if not zero(size(w[0])) and not zero(size(w[1])):
            q[f"angle_between_{name}_deg"] = angle((dot(w[0], w[1]), abs(cross(w[0], w[1]))))
    w = minus(u[0], u[1])
    q["alpha_deg"] = angle((abs(dot(w, n)), abs(cross(w, n))))
    return q, v


# --- random data, as text ---
def choose(*options): return rnd.choice(options)

def small(): return str(F(rnd.randint(-9, 9), choose(1, 1, 1, 2, 3)))
def positive():
    return choose(str(rnd.randint(1, 9)), str(F(rnd.randint(1, 9), rnd.randint(1, 5))), "0.25", "1.5")
def surd():
    return choose("sqrt(2)", "2*sqrt(3)", "3*sqrt(2)/2", "1+sqrt(2)", "sqrt(3)-1", "sqrt(6)/3", "-sqrt(5)", "2-sqrt(3)")
def restitution():
    return choose("0", "1", "1/2", "1/3", "2/3", "3/4", "3/5", "0.25", "sqrt(2)/3", "sqrt(3)/2", "2/7")
def component(kind):
    if kind == "surd" and rnd.random() < 0.5: return surd()
    return small()
def velocity(kind):
    r = rnd.random()
    if r < 0.12: return ["0", "0"]
    if kind == "degrees" and r < 0.9:
        return {"speed": choose(positive(), "sqrt(3)", "2*sqrt(2)"),
                "angle_deg": choose(str(rnd.randint(0, 360)), str(rnd.randint(-180, 180)), "22.5", "7.5", str(15 * rnd.randint(-12, 24)))}
    if kind == "triangle" and r < 0.9:
        a, b, c = choose((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25))
        if rnd.random() < 0.5: a, b = b, a
        return {"speed": positive(), "cos": str(F(choose(1, -1) * a, c)), "sin": str(F(choose(1, -1) * b, c))}
    return [component(kind), component(kind)]
def line(kind):
    return choose(["1", "0"], ["0", "1"], ["-1", "0"], ["0", "-2"], ["1", "2"], ["3", "-4"], ["1", "sqrt(3)"], ["1", "1"],
                  ["-2", "3"], ["sqrt(2)", "-1"], ["-5", "-12"])

def read_velocity(text, letters=None):
    if isinstance(text, list): return tuple(number(c, letters) for c in text)
    s = number(text["speed"], letters)
    if "angle_deg" in text:
        a = number("(" + text["angle_deg"] + ")", letters)
        # A letter stands for an angle, a number for degrees.
        a = a if re.search(r"[a-z]", text["angle_deg"].replace("deg", "").replace("atan", "")) and letters else a * deg
        return (s * mp.cos(a), s * mp.sin(a))
    return (s * number(text["cos"], letters), s * number(text["sin"], letters))


def forward(kind):
    scene = {"masses": {"A": positive(), "B": positive()}, "before": {"A": velocity(kind), "B": velocity(kind)},
             "line_of_centres": line(kind), "e": restitution()}
    if rnd.random() < 0.15:
        scene["before"]["B"] = ["0", "0"]
    u = [read_velocity(scene["before"][X]) for X in "AB"]
    n = tuple(number(c) for c in scene["line_of_centres"])
    approach = dot(minus(u[0], u[1]), n)
    if zero(approach): return None
    if approach < 0:
        if rnd.random() < 0.5: scene["sense"] = "either"
        n = times(-1, n)
    elif rnd.random() < 0.5:
        scene["sense"] = "A_to_B"
    m = [number(scene["masses"][X]) for X in "AB"]
    return scene, quantities(m, u, n, number(scene["e"])), {}


def lettered():
    """Letters for masses, speeds, e and an acute angle, each with a number at which formulas are compared."""
    letters = {"m": mp.mpf("1.37"), "u": mp.mpf("2.71"), "e": mp.mpf("0.43"), "k": mp.mpf("0.77"), "alpha": mp.mpf("0.61"), "v": mp.mpf("1.19")}
    ranges = {"m": "positive", "u": "positive", "e": "unit", "k": "positive", "alpha": "acute", "v": "positive"}
    masses = choose(("m", "m"), ("m", "2*m"), ("m", "k*m"), ("3*m", "m"), ("m/2", "3*m/2"))
    A = choose(["u*cos(alpha)", "u*sin(alpha)"], {"speed": "u", "angle_deg": "30"}, {"speed": "u", "angle_deg": "alpha"}, ["u", "2*u"], {"speed": "2*u", "cos": "3/5", "sin": "-4/5"}, ["u", "v"], {"speed": "u", "angle_deg": "20"})
    B = choose(["0", "0"], ["0", "0"], ["-u", "0"], ["-v", "v"], {"speed": "u", "angle_deg": "120"}, ["-u/2", "u"])
    if rnd.random() < 0.5: B = ["0", "0"]
    scene = {"masses": dict(zip("AB", masses)), "before": {"A": A, "B": B},
             "line_of_centres": choose(["1", "0"], ["1", "0"], ["1", "1"], ["3", "4"]), "sense": "A_to_B", "e": choose("e", "e", "1/2", "0", "1")}
    text = json.dumps(scene)
    used = {name for name in ranges if re.search(rf"\b{name}\b", re.sub(r'"(masses|before|A|B|e|speed|cos|sin)":', "", text))}
    scene["symbols"] = {name: ranges[name] for name in sorted(used)}
    u = [read_velocity(scene["before"][X], letters) for X in "AB"]
    n = tuple(number(c) for c in scene["line_of_centres"])
    if dot(minus(u[0], u[1]), n) <= 0: return None
    m = [number(scene["masses"][X], letters) for X in "AB"]
    return scene, quantities(m, u, n, number(scene["e"], letters)), {k: letters[k] for k in used}


def contact():
    """Positions and radii, touching or apart, and impact parameters of either sign."""
    r = rnd.random()
    scene = {"masses": {"A": positive(), "B": positive()}, "before": {"A": velocity("rational"), "B": velocity("rational")}, "e": restitution()}
    u = [read_velocity(scene["before"][X]) for X in "AB"]
    w = minus(u[0], u[1])
    if zero(size(w)): return None
    radii = choose(("1", "1"), ("2", "3"), ("1/2", "3/2"), ("5", "5"))
    scene["radii"] = dict(zip("AB", radii))
    total = number(radii[0]) + number(radii[1])
    if r < 0.4:
        d = str(F(rnd.randint(-9, 9), 10) * F(rnd.choice([1, 2, 5])))
        if abs(number(d)) >= total: return None
        scene["impact_parameter"] = d
        offset = number(d)
    else:
        touching = r < 0.7
        a, b, c = choose((3, 4, 5), (0, 1, 1), (1, 0, 1), (5, 12, 13))
        a, b = choose(1, -1) * a, choose(1, -1) * b
        sum_radii = F(radii[0]) + F(radii[1])
        gap = sum_radii * (1 if touching else rnd.choice([2, 3]))
        at = (F(rnd.randint(-3, 3)), F(rnd.randint(-3, 3)))
        to = (at[0] + gap * a / c, at[1] + gap * b / c)
        scene["positions"] = {"A": [str(x) for x in at], "B": [str(x) for x in to]}
        d = (mp.mpf(gap.numerator) / gap.denominator * a / c, mp.mpf(gap.numerator) / gap.denominator * b / c)
        if dot(w, d) <= 0: return None
        if touching:
            return scene, quantities([number(scene["masses"][X]) for X in "AB"], u, d, number(scene["e"])), {}
        offset = cross(w, d) / size(w)
        if abs(offset) >= total: return None
    sine = offset / total
    cosine = mp.sqrt(1 - sine * sine)
    unit = times(1 / size(w), w)
    n = (unit[0] * cosine - unit[1] * sine, unit[1] * cosine + unit[0] * sine)
    return scene, quantities([number(scene["masses"][X]) for X in "AB"], u, n, number(scene["e"])), {}


def exact_after(scene):
    """The velocities after as fractions in text, for a scene of fractions alone."""
    m = [F(scene["masses"][X]) for X in "AB"]
    u = [tuple(F(c) for c in scene["before"][X]) for X in "AB"]
    n = tuple(F(c) for c in scene["line_of_centres"])
    if dot(minus(u[0], u[1]), n) < 0: n = times(-1, n)
    e = F(scene["e"])
    k = m[0] * m[1] / (m[0] + m[1]) * (1 + e) * dot(minus(u[0], u[1]), n) / dot(n, n)
    return [minus(u[0], times(k / m[0], n)), plus(u[1], times(k / m[1], n))], n


INVERSE = {
    "after A": lambda s, a: (s.update(after={"A": a[0]}), s.pop("line_of_centres"), s.pop("e")),
    "after B": lambda s, a: (s.update(after={"B": a[1]}), s.pop("line_of_centres"), s.pop("e")),
    "after both, mass of A open": lambda s, a: (s.update(after=dict(zip("AB", a))), s.pop("line_of_centres"), s.pop("e"), s["masses"].pop("A")),
    "after both, mass of B null": lambda s, a: (s.update(after=dict(zip("AB", a))), s.pop("line_of_centres"), s.pop("e"), s["masses"].update(B=None)),
    "after both, everything but e": lambda s, a: (s.update(after=dict(zip("AB", a))), s.pop("e")),
    "line and after A, e open": lambda s, a: (s.update(after={"A": a[0]}), s.pop("e")),
    "line and after B, e open": lambda s, a: (s.update(after={"B": a[1]}), s.pop("e")),
    "before A open, after both": lambda s, a: (s.update(after=dict(zip("AB", a))), s["before"].pop("A"), s.pop("line_of_centres"), s.pop("e")),
    "before B open, after both": lambda s, a: (s.update(after=dict(zip("AB", a))), s["before"].pop("B"), s.pop("line_of_centres"), s.pop("e")),
    "before both open": lambda s, a: (s.update(after=dict(zip("AB", a)), sense="A_to_B"), s.pop("before")),
    "before A and after B open": lambda s, a: (s.update(after={"A": a[0]}, sense="A_to_B"), s["before"].pop("A")),
    "before A and after A open": lambda s, a: (s.update(after={"B": a[1]}, sense="A_to_B"), s["before"].pop("A")),
    "before B and after A open": lambda s, a: (s.update(after={"B": a[1]}, sense="A_to_B"), s["before"].pop("B")),
    "mass A open, e and line given": lambda s, a: (s.update(after={"A": a[0]}), s["masses"].pop("A")),
    "mass B open, e and line given": lambda s, a: (s.update(after={"A": a[0]}), s["masses"].pop("B")),
    "mass A open, after B, e and line given": lambda s, a: (s.update(after={"B": a[1]}), s["masses"].pop("A")),
    "masses open, velocities given": lambda s, a: (s.update(after=dict(zip("AB", a))), s.pop("masses"), s.pop("e"), s.pop("line_of_centres")),
    "after A in polar form": lambda s, a: (s.update(after={"A": {"speed": f"sqrt({dot(a[0], a[0])})", "cos": f"{a[0][0]}/sqrt({dot(a[0], a[0])})", "sin": f"{a[0][1]}/sqrt({dot(a[0], a[0])})"}}), s.pop("line_of_centres"), s.pop("e")),
}


def inverse(pattern):
    scene = {"masses": {"A": str(rnd.randint(1, 6)), "B": str(rnd.randint(1, 6))},
             "before": {X: [str(rnd.randint(-6, 6)), str(rnd.randint(-6, 6))] for X in "AB"},
             "line_of_centres": choose(["1", "0"], ["1", "1"], ["1", "-2"], ["3", "4"]), "e": choose("1/2", "1/3", "3/4", "1", "2/5", "0")}
    u = [tuple(F(c) for c in scene["before"][X]) for X in "AB"]
    if dot(minus(u[0], u[1]), tuple(F(c) for c in scene["line_of_centres"])) == 0: return None
    if scene["e"] == "0" and "before" in pattern: return None
    after, n = exact_after(scene)
    if "polar" in pattern and dot(after[0], after[0]) == 0: return None
    scene["line_of_centres"] = [str(c) for c in n]
    # Without the masses only what has no mass in it is determined.
    real = lambda f: mp.mpf(f.numerator) / f.denominator
    truth = quantities([number(scene["masses"][X]) for X in "AB"], [tuple(map(real, v)) for v in u], tuple(map(real, n)), number(scene["e"]))
    if pattern == "before A and after A open":
        # What A does along the tangent leaves no trace on B.
        keep = [k for k in truth[0] if re.match(r"(A\.(before|after)\.n|B\.(mass|before|after|impulse|ke|defl|tan).*|A\.(mass|impulse.*|ke_lost)|impulse.*|approach|separation|e|mass_ratio|[nt]\.[xy]|ke.lost)$", k)]
        truth = ({k: truth[0][k] for k in keep}, truth[1])
    if "masses open" in pattern:
        keep = {k: v for k, v in truth[0].items() if not re.search(r"mass$|ke|\.p[xy]$|impulse|momentum|fraction", k)}
        keep["ke.fraction_lost"] = truth[0]["ke.fraction_lost"]
        truth = (keep, truth[1])
    text = [[str(c) for c in v] for v in after]
    if "polar" in pattern: INVERSE[pattern](scene, after)
    else: INVERSE[pattern](scene, text)
    return scene, truth, {}


def untidy(exact):
    """What a careful teacher would write otherwise."""
    faults = []
    for match in re.finditer(r"sqrt\((\d+)(?:/(\d+))?\)", exact):
        if match.group(2): faults.append("fraction under a root")
        n = int(match.group(1))
        if any(n % (p * p) == 0 for p in range(2, 50)): faults.append("square under a root")
    for match in re.finditer(r"(?<![\w.)*^])(\d+)/(\d+)(?![\w.])", exact):
        import math
        if math.gcd(int(match.group(1)), int(match.group(2))) > 1: faults.append("fraction not in lowest terms")
    if re.search(r"/(\d+\*)?(\(\d+ [-+] )?(\d+\*)?sqrt", exact) and not re.search(r"atan|acos", exact): faults.append("root below a fraction line")
    if re.search(r"sqrt\([^()]*sqrt\(", exact) and not re.search(r"[a-z]", re.sub(r"sqrt|atan|deg|sin|cos|abs", "", exact)) and "deg" not in exact:
        value = sp.sympify(exact.replace("^", "**"))
        if sp.sqrtdenest(value) != value and str(sp.sqrtdenest(value)).count("sqrt(") < str(value).count("sqrt("): faults.append(f"denests to {sp.sqrtdenest(value)}")
    if re.search(r"(^|[^\w.])1\*|\+ ?-|--|\*1(?![\d.])", exact): faults.append("odd signs or ones")
    return faults


def compare(scene, truth, letters, answer):
    """Complaints about one answer."""
    if "stopped or slower than" in answer:
        return [("slow", "stopped, or no answer in 10 s")]
    if "solutions" not in answer:
        return [("no answer", json.dumps({k: v for k, v in answer.items() if k != "seconds"}))]
    found = answer["solutions"][0]["quantities"]
    truth = truth[0]
    complaints = []
    for name, value in truth.items():
        if name not in found:
            complaints.append(("missing", name))
            continue
        exact = found[name]["exact"]
        try: got = number(exact, letters)
        except Exception as fault:
            complaints.append(("unreadable", f"{name} = {exact}: {fault}"))
            continue
        scale = max(abs(value), 1)
        if abs(got - value) > scale * mp.mpf(10) ** -35:
            complaints.append(("WRONG", f"{name} = {exact} = {mp.nstr(got, 15)}, not {mp.nstr(value, 15)}"))
        if zero(value) and exact != "0":
            complaints.append(("zero not decided", f"{name} = {exact}"))
        decimal = found[name]["decimal"]
        if letters and decimal is None and re.search(r"\b(" + "|".join(letters) + r")\b", exact): pass
        elif decimal is None: complaints.append(("no decimal", f"{name} = {exact}"))
        elif abs(mp.mpf(decimal) - value) > abs(value) * mp.mpf(10) ** -14 + mp.mpf(10) ** -40: complaints.append(("WRONG decimal", f"{name} = {decimal}, not {mp.nstr(value, 17)}"))
        for fault in untidy(exact): complaints.append(("untidy", f"{fault}: {name} = {exact}"))
    for name in found:
        if name not in truth: complaints.append(("too much", f"{name} = {found[name]['exact']}"))
    if answer["seconds"] > 1: complaints.append(("slow", f"{answer['seconds']:.2f} s"))
    return complaints


class Stream:
    """The program, asked one scene at a time; started again when it takes too long or stops."""

    def __init__(self, path):
        self.path, self.run = path, None

    def ask(self, scene, limit=10):
        if self.run is None:
            self.run = subprocess.Popen([self.path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.run.stdin.write(json.dumps(scene) + "\n")
        self.run.stdin.flush()
        timer = threading.Timer(limit, self.run.kill)
        timer.start()
        line = self.run.stdout.readline()
        timer.cancel()
        if line:
            return json.loads(line)
        self.run.wait()
        self.run = None
        return {"stopped or slower than": limit, "seconds": float(limit)}


def main():
    program, count, seed = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 300, int(sys.argv[3]) if len(sys.argv) > 3 else 1
    rnd.seed(seed)
    makers = [("rational", lambda: forward("rational")), ("surd", lambda: forward("surd")), ("triangle", lambda: forward("triangle")), ("degrees", lambda: forward("degrees")), ("letters", lettered), ("contact", contact)]
    makers += [(name, lambda name=name: inverse(name)) for name in INVERSE]
    weights = [3, 3, 3, 3, 5, 4] + [0.5] * len(INVERSE)
    cases = []
    while len(cases) < count:
        kind, make = rnd.choices(makers, weights)[0]
        made = make()
        if made: cases.append((kind,) + made)
    program = Stream(program)
    answers = [program.ask(scene) for _, scene, _, _ in cases]
    worst, seen, total = 0, {}, 0
    for (kind, scene, truth, letters), answer in zip(cases, answers):
        worst = max(worst, answer["seconds"])
        complaints = compare(scene, truth, letters, answer)
        total += bool(complaints)
        for what, detail in complaints:
            seen.setdefault((kind, what), []).append((len(json.dumps(scene)), detail, scene))
    for (kind, what), list_ in sorted(seen.items()):
        print(f"== {kind}: {what} ({len(list_)})")
        for length, detail, scene in sorted(list_, key=lambda x: x[0])[:3]:
            print("  ", detail[:300], "\n      ", json.dumps(scene))
    print(f"{len(cases)} scenes, {total} with complaints; slowest {worst:.3f} s, all {sum(a['seconds'] for a in answers):.1f} s")
    sys.exit(1 if total else 0)


if __name__ == "__main__":
    main()
