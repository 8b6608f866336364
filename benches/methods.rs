//! How long an impact takes by each method, and the ratios that `docs/design.md` speaks of.
//!
//! A time says as much of the machine as of the method, so what is stated is ratios: both sides take turns within one run,
//! and the least of many turns counts. With `RUSTFLAGS="-C target-cpu=native"` the compiler may fuse multiplication and
//! addition, and take several impacts at a time.

use std::hint::black_box;
use std::time::{Duration, Instant};

use carom::method::{Impact, METHODS, Numbers, Prepared, figures, method};
use carom::number::{Places, Value};
use divan::Bencher;

fn main() {
    ratios();
    divan::main();
}

/// How many impacts a batch has.
const BATCH: usize = 1024;

/// Head-on impacts of whole masses and speeds with B moving, and e of small denominators.
fn exam(count: usize) -> Vec<Impact<Value>> {
    let one = |number: usize| {
        let whole = |factor: usize, below: usize| i64::try_from(number * factor % below).expect("small");
        let (p, q) = (whole(3, 5), 5 + whole(7, 5));
        Impact {
            masses: [Value::from(1 + whole(5, 9)), Value::from(1 + whole(11, 7))],
            before: [[Value::from(2 + whole(13, 8)), Value::ZERO], [Value::from(-1 - whole(17, 6)), Value::ZERO]],
            line: [Value::ONE, Value::ZERO],
            restitution: Value::fraction(p, q),
        }
    };
    (0..count).map(one).collect()
}

/// The same at 30, 45 or 60 degrees to the line of centres.
fn surds(count: usize) -> Vec<Impact<Value>> {
    let root = |number| Value::from(number).square_root().expect("positive");
    let turned = |(number, impact): (usize, Impact<Value>)| {
        let cos = [root(3), root(2), Value::ONE][number % 3].clone();
        let sin = [Value::ONE, root(2), root(3)][number % 3].clone();
        let speed = &impact.before[0][0] * &Value::fraction(1, 2);
        Impact { before: [[&speed * &cos, &speed * &sin], impact.before[1].clone()], ..impact }
    };
    exam(count).into_iter().enumerate().map(turned).collect()
}

/// The same with e a surd.
fn surd_restitution(count: usize) -> Vec<Impact<Value>> {
    let root = Value::from(2).square_root().expect("positive");
    surds(count).into_iter().map(|impact| Impact { restitution: &root * &Value::fraction(1, 3), ..impact }).collect()
}

fn prepared(name: &str, impacts: &[Impact<Value>]) -> Box<dyn Prepared> {
    let method = method(name).expect(name);
    method.prepare(impacts).unwrap_or_else(|skip| panic!("{name}: impact {}: {}", skip.place, skip.why))
}

/// How long two things take turns.
const LONG_ENOUGH: Duration = Duration::from_millis(400);

/// The least time of each of two things that take turns.
fn turns(one: &mut dyn FnMut(), other: &mut dyn FnMut()) -> [Duration; 2] {
    let time = |thing: &mut dyn FnMut()| {
        let start = Instant::now();
        thing();
        start.elapsed()
    };
    let mut least = [Duration::MAX; 2];
    let begun = Instant::now();
    while begun.elapsed() < LONG_ENOUGH {
        least = [least[0].min(time(one)), least[1].min(time(other))];
    }
    least
}

/// A ratio in a line, with what is aimed at.
fn state(what: &str, [one, other]: [Duration; 2], count: usize, goal: &str) {
    let each = |time: Duration| time.as_secs_f64() * 1e9 / count as f64;
    let ratio = one.as_secs_f64() / other.as_secs_f64();
    println!("{what:<56} {ratio:>8.2}   {:>9.2} ns / {:.2} ns   {goal}", each(one), each(other));
}

/// Two methods on the same impacts.
fn compare(one: &str, other: &str, impacts: &[Impact<Value>], kind: &str, goal: &str) {
    let (mut first, mut second) = (prepared(one, impacts), prepared(other, impacts));
    let times = turns(&mut || black_box(&mut first).run(), &mut || black_box(&mut second).run());
    state(&format!("{one} / {other}, {kind}"), times, impacts.len(), goal);
}

/// Reads five columns and writes two, with next to no arithmetic: row by row, or so many rows at a time. Which is quicker
/// depends on the processor that the compiler has in mind.
struct Traffic([Vec<f64>; 7]);

impl Traffic {
    fn new(count: usize) -> Traffic {
        Traffic(std::array::from_fn(|column| vec![1.0 + column as f64; count]))
    }

    fn by_rows(&mut self) {
        let [a, b, c, d, e, x, y] = &mut self.0;
        let rows = a.len();
        let [a, b, c, d, e] = [a, b, c, d, e].map(|column| &column[..rows]);
        let [x, y] = [x, y].map(|column| &mut column[..rows]);
        for row in 0..rows {
            x[row] = a[row] + b[row] + c[row];
            y[row] = d[row] + e[row];
        }
    }

    fn by_lanes(&mut self) {
        const LANES: usize = 8;
        let [a, b, c, d, e, x, y] = &mut self.0;
        let outs = x.chunks_exact_mut(LANES).zip(y.chunks_exact_mut(LANES));
        let ins = a.chunks_exact(LANES).zip(b.chunks_exact(LANES)).zip(c.chunks_exact(LANES));
        let ins = ins.zip(d.chunks_exact(LANES)).zip(e.chunks_exact(LANES));
        for (((((a, b), c), d), e), (x, y)) in ins.zip(outs) {
            for lane in 0..LANES {
                x[lane] = a[lane] + b[lane] + c[lane];
                y[lane] = d[lane] + e[lane];
            }
        }
    }
}

fn ratios() {
    println!("{:<56} {:>8}   least times for one impact", "what", "ratio");
    let (exam, angles, surd) = (exam(BATCH), surds(BATCH), surd_restitution(BATCH));
    compare("integers", "ratio-from-integers", &exam, "fractions", "at most 1.25");
    compare("integers", "ratio", &exam, "fractions", "");
    compare("certified-float", "ratio-from-integers", &exam, "fractions", "");
    compare("certified-float", "ratio", &exam, "fractions", "at most 5, with fused multiply-add 2.5");
    compare("surd-integers", "ratio", &angles, "30, 45, 60 degrees", "");
    compare("linear-forms", "ratio", &angles, "30, 45, 60 degrees", "");
    compare("surd-field", "ratio", &surd, "e a surd", "");
    compare("fractions", "integers", &exam, "fractions", "");
    compare("letters", "integers", &exam, "fractions", "");
    compare("letters", "surd-field", &surd, "e a surd", "");
    compare("textbook", "ratio", &exam, "fractions", "");
    compare("ratio-fused", "ratio", &exam, "fractions", "");
    compare("double-double", "ratio", &exam, "fractions", "");
    compare("float-intervals", "ratio", &exam, "fractions", "");
    for count in [BATCH, 1 << 20] {
        let (mut traffic, mut columns) = (Traffic::new(count), prepared("columns", &self::exam(count)));
        let by_rows = turns(&mut || black_box(&mut traffic).by_rows(), &mut || black_box(&mut columns).run());
        let by_lanes = turns(&mut || black_box(&mut traffic).by_lanes(), &mut || black_box(&mut columns).run());
        let times = std::array::from_fn(|side| by_rows[side].min(by_lanes[side]));
        state(&format!("traffic alone / columns, {count} impacts"), times, count, "at least 0.9");
    }
    let three = Places::SignificantFigures(3);
    let mut exact = prepared("integers", &exam);
    let rounded = || exam.iter().for_each(|impact| drop(black_box(figures(impact, &three))));
    let times = turns(&mut || rounded(), &mut || black_box(&mut exact).run());
    state("choosing, solving and rounding / integers", times, BATCH, "");
    println!();
}

/// Every method on the impacts that it takes, a batch at a time.
#[divan::bench(args = METHODS.iter().map(|method| method.name()), sample_count = 20)]
fn a_thousand_impacts(bencher: Bencher, name: &str) {
    // Simulations take their time.
    let count = if ["spring-verlet", "spring-runge-kutta"].contains(&name) { 4 } else { BATCH };
    // No spring stops spheres that do not rebound at all.
    let takes = |impact: &Impact<Value>| method(name).expect(name).prepare(std::slice::from_ref(impact)).is_ok();
    let taken: Vec<Impact<Value>> = exam(2 * count).into_iter().filter(takes).take(count).collect();
    let mut batch = prepared(name, &taken);
    bencher.counter(divan::counter::ItemsCount::new(count)).bench_local(|| black_box(&mut batch).run());
}

/// Every tier of the answer path with what it takes to make ready, for one impact.
#[divan::bench(args = Numbers::ALL.iter().map(|tier| tier.name()))]
fn one_impact_made_ready(bencher: Bencher, name: &str) {
    let impacts = exam(1);
    bencher.bench(|| {
        let mut batch = prepared(name, black_box(&impacts));
        batch.run();
        batch.found()
    });
}
