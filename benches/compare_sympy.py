"""The same pairs compared by sympy, warm, and by `carom compare --stream`: microseconds an answer, and the ratio.

    pip install sympy && cargo build --release && python3 benches/compare_sympy.py

Sympy parses the answer and asks `.equals`, once with its cache emptied and once with what it remembers of the very same
question; Carom remembers the model of its first line, reads the answer in a student's notation and
writes a verdict. Each figure is the best of some repetitions of processor time.
"""

import json
import resource
import subprocess
import time

import sympy
from sympy.parsing.sympy_parser import parse_expr

PAIRS = [
    ("4*sqrt(39)/9", "sqrt(208/27)"),
    ("4*sqrt(39)/9", "4*sqrt(13)/(3*sqrt(3))"),
    ("16*sqrt(3)/9", "16/(3*sqrt(3))"),
    ("10/43", "20/86"),
    ("u*(1-e)/2", "(u-u*e)/2"),
    ("u*(1-e)/2", "u*(1-e**2)/(2*(1+e))"),
    ("u*(1-e)/2", "u*(1+e)/2"),
    ("9*m*u**2/4", "m*(3*u/2)**2"),
    ("u*sqrt(cos(theta)**2+e**2*sin(theta)**2)", "u*sqrt(1-(1-e**2)*sin(theta)**2)"),
    ("(1+e)*tan(theta)/(2*tan(theta)**2+1-e)", "(1+e)*sin(theta)*cos(theta)/(2-(1+e)*cos(theta)**2)"),
]
CAROM = ["target/release/carom", "compare", "--stream"]
NAMES = {name: sympy.Symbol(name, positive=True) for name in ["u", "m", "e", "theta"]}


def by_sympy(model, answer):
    right = parse_expr(model, NAMES)

    def best(prepare):
        times = []
        for _ in range(5):
            prepare()
            start = time.process_time()
            equal = parse_expr(answer, NAMES).equals(right)
            times.append(time.process_time() - start)
        return min(times) * 1e6, equal

    (emptied, equal), (kept, _) = best(sympy.core.cache.clear_cache), best(lambda: None)
    return emptied, kept, equal


def by_carom(model, answer):
    def spent(count):
        line = json.dumps({"model": model.replace("**", "^"), "answer": answer.replace("**", "^")}) + "\n"
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        out = subprocess.run(CAROM, input=line * count, capture_output=True, text=True, check=True).stdout
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, json.loads(out.splitlines()[0])

    few, many = 100, 5100
    return min((spent(many)[0] - spent(few)[0]) / (many - few) for _ in range(3)) * 1e6, spent(1)[1]["verdict"]


print(f"{'sympy':>10} {'recalled':>10} {'carom':>8} {'ratios':>13}")
for model, answer in PAIRS:
    (emptied, kept, equal), (quick, verdict) = by_sympy(model, answer), by_carom(model, answer)
    ratios = f"{emptied / quick:7.0f} {kept / quick:5.0f}"
    print(f"{emptied:10.1f} {kept:10.1f} {quick:8.1f} {ratios}  {answer} for {model}: {equal}, {verdict}")
