//! Variants of the shipped bank, and random impacts with them, before a judge that shares nothing with the laws.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use carom::answer::Accept;
use carom::bank::{Bank, Question, Style};
use carom::expr::print;
use carom::generate::examine;
use carom::mechanics::{
    Axis, Contact, Datum, Derivation, Known, Moment, Quantity, Scene, Sphere, Values, Velocity, pose,
};
use carom::method::{Found, Impact, METHODS, Promise, method, solve_once};
use carom::number::{End, Fraction, Interval, Letter, Places, Range, Value};
use carom::solve::Solution;

use super::agreement::agree;
use super::alone;
use super::judge::{Outcome, approach, by_definition, judge, to_judge};
use super::later;
use super::scenes::{Kind, generator, random};

/// How much of the bank is examined, and what must have been judged in the end.
struct Extent {
    /// Every so-manieth set of numbers.
    share: u64,
    /// So many random impacts are added.
    random: u64,
    least: u64,
    least_variants: u64,
}

const PORTION: u64 = 16;

/// How much of each check was done: a check that is never reached proves nothing.
#[derive(Debug, Default)]
struct Tally {
    judged: u64,
    /// Of one body, before a judge of its own.
    alone: u64,
    in_fractions: u64,
    with_letters: u64,
    agreed: usize,
    by_other_methods: u64,
    answers: u64,
    printed: u64,
}

impl Tally {
    fn add(&mut self, other: &Tally) {
        self.judged += other.judged;
        self.alone += other.alone;
        self.in_fractions += other.in_fractions;
        self.with_letters += other.with_letters;
        self.agreed += other.agreed;
        self.by_other_methods += other.by_other_methods;
        self.answers += other.answers;
        self.printed += other.printed;
    }
}

/// What an outcome is made of.
fn whole() -> Vec<Quantity> {
    let mut all = vec![Quantity::Restitution, Quantity::EnergyLost, Quantity::Line(Axis::X), Quantity::Line(Axis::Y)];
    for sphere in Sphere::BOTH {
        all.push(Quantity::Mass(sphere));
        for moment in [Moment::Before, Moment::After] {
            all.extend([Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, moment, axis)));
        }
    }
    all
}

/// What the scene gives itself is taken from it, and only the rest from what was derived.
fn outcome(scene: &Scene, known: &Known<Value>) -> Option<Outcome<Value>> {
    let velocity = |sphere: Sphere, moment: Moment| {
        Some(match scene.velocity(sphere, moment) {
            Some(Velocity::Components(x, y)) => [x.value.clone(), y.value.clone()],
            Some(Velocity::Polar { speed, cos, sin, .. }) => [&speed.value * cos, &speed.value * sin],
            None => known.numbers([Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, moment, axis)))?,
        })
    };
    let mass = |sphere| match scene.mass(sphere) {
        Some(given) => Some(given.value.clone()),
        None => known.number(Quantity::Mass(sphere)),
    };
    let both = |moment| Some([velocity(Sphere::A, moment)?, velocity(Sphere::B, moment)?]);
    let before = both(Moment::Before)?;
    let line = match &scene.contact {
        // Without a sense the line points the way in which the spheres approach.
        Some(Contact::Along(x, y, sense)) => {
            let line = [x.clone(), y.clone()];
            let apart = sense.is_none() && approach(&before, &line).sign() == Some(std::cmp::Ordering::Less);
            if apart { line.map(|component| -component) } else { line }
        }
        _ => known.numbers([Quantity::Line(Axis::X), Quantity::Line(Axis::Y)])?,
    };
    Some(Outcome {
        masses: [mass(Sphere::A)?, mass(Sphere::B)?],
        before,
        after: both(Moment::After)?,
        line,
        e: match &scene.restitution {
            Some(given) => given.value.clone(),
            None => known.number(Quantity::Restitution)?,
        },
        lost: known.number(Quantity::EnergyLost)?,
    })
}

/// Numbers for letters, other ones for each sample; an angle has its tangent.
fn sample(letter: Letter, number: i64) -> Interval {
    let spread = letter.name().bytes().fold(number * 5, |sum, byte| (sum * 31 + i64::from(byte)) % 97);
    let value = match letter.range() {
        Range::Unit => Fraction::new(spread + 1, 99),
        Range::Acute => Fraction::new(spread + 1, 40),
        _ => Fraction::new(spread + 11, 23),
    };
    Interval::from_fraction(&value, 128)
}

/// The same; a letter of which a range was found lies in it.
fn in_range(value: &Value, number: i64, range: Option<&Values>) -> Option<f64> {
    let end = |end: &Option<End>| end.as_ref().and_then(|end| end.value.to_f64());
    let within = |letter: Letter| {
        let values = range.filter(|values| values.letter == letter)?;
        let low = end(&values.span.low).unwrap_or(0.0);
        let high = end(&values.span.high).unwrap_or(low + 5.0);
        let value = Fraction::from_f64(low + (high - low) * number as f64 / 41.0)?;
        Some(Interval::from_fraction(&value, 128))
    };
    Some(value.enclose(128, &|letter| within(letter).or_else(|| Some(sample(letter, number))))?.to_f64())
}

/// A value in a sample of its letters, as a double.
pub fn in_sample(value: &Value, number: i64) -> Option<f64> {
    Some(value.enclose(128, &|letter| Some(sample(letter, number)))?.to_f64())
}

/// Is a printed decimal within half a unit of its last figure?
pub fn rounds_to(printed: f64, places: &Places, value: f64) -> bool {
    let unit = match places {
        Places::SignificantFigures(count) => {
            let first = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
            10_f64.powf(first + 1.0 - f64::from(*count))
        }
        Places::DecimalPlaces(count) => 10_f64.powf(-f64::from(*count)),
        Places::Nearest(step) => step.decimal().to_fraction().to_f64(),
    };
    (printed - value).abs() <= unit / 2.0 + 1e-9 * value.abs().max(1.0)
}

pub fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-9 * expected.abs().max(1.0)
}

/// The impact once more in doubles, by elimination; the outcome's own velocities after and loss are not used.
fn once_more(case: &Outcome<f64>) -> Option<Outcome<f64>> {
    let exactly = |number: &f64| Fraction::from_f64(*number).map(Value::from);
    let impact = Impact { masses: case.masses, before: case.before, line: case.line, restitution: case.e };
    let Ok(Found::Float(after)) = solve_once(method("elimination")?, &impact.turned_into(exactly)?) else {
        return None;
    };
    let mut again = Outcome { after, ..case.clone() };
    again.lost = by_definition(Quantity::EnergyLost, &again)?;
    Some(again)
}

/// All checks of one impact that was solved, with what is asked of it.
fn check(solution: &Solution, asked: &[(Quantity, Accept)], tally: &mut Tally) -> Result<(), String> {
    let scene = solution.scene();
    let given = pose(scene).map_err(|refusal| refusal.to_string())?;
    let mut known = given.clone();
    let mut all = whole();
    all.extend(asked.iter().map(|(quantity, _)| *quantity));
    let (derivation, missing) = Derivation::carry_out(&mut known, &all);
    if !missing.is_empty() {
        return Err(format!("not found: {missing:?}"));
    }
    let case = outcome(scene, &known).ok_or("an outcome that is not whole")?;
    match case.turned_into(to_judge) {
        Some(rational) => {
            tally.in_fractions += 1;
            judge(&rational)?;
        }
        None => judge(&case)?,
    }
    tally.judged += 1;
    for condition in &scene.conditions {
        let sides = [&condition.left, &condition.right].map(print::plain);
        let [[u, _], [v, _]] = [&case.before, &case.after];
        match [sides[0].as_str(), sides[1].as_str()] {
            ["A.deflection_dot", "0"] if (&(&u[0] * &v[0]) + &(&u[1] * &v[1])).is_zero() => {}
            [left, right] => return Err(format!("the condition {left} = {right}")),
        }
    }
    let impact = Impact {
        masses: case.masses.clone(),
        before: case.before.clone(),
        line: case.line.clone(),
        restitution: case.e.clone(),
    };
    let exact = METHODS.iter().filter(|method| method.promises() == Promise::Exact);
    let mut found = 0;
    for method in exact {
        let Ok(Found::Exact(after)) = solve_once(*method, &impact) else { continue };
        if after.as_flattened().iter().zip(case.after.as_flattened()).any(|(one, other)| !one.equals(other)) {
            return Err(format!("{} finds another velocity", method.name()));
        }
        found += 1;
    }
    tally.by_other_methods += u64::from(found > 0);
    if known.0.iter().all(|(_, datum)| is_constant(datum)) {
        tally.agreed += agree(&given, &derivation, &known, &format!("{scene:?}"));
        in_numbers(solution, &case, asked, &|value| value.to_f64(), tally)
            .unwrap_or_else(|| Err("no doubles".to_owned()))?;
        return Ok(());
    }
    tally.with_letters += 1;
    let mut samples = 0;
    for number in 1..40 {
        let float = |value: &Value| in_range(value, number, solution.range());
        // A path that misses, or an e too small for what is said, has no number.
        let Some(checked) = in_numbers(solution, &case, asked, &float, tally) else { continue };
        checked.map_err(|complaint| format!("{complaint} in sample {number}"))?;
        samples += 1;
        if samples == 2 {
            return Ok(());
        }
    }
    Err("no two sets of numbers for its letters".to_owned())
}

fn is_constant(datum: &Datum<Value>) -> bool {
    match datum {
        Datum::Number(value) => value.is_constant(),
        Datum::Direction { y, x } => y.is_constant() && x.is_constant(),
        Datum::Equation(coefficients) => coefficients.iter().all(Value::is_constant),
    }
}

/// Answers against the impact once more in doubles; `None` where a value has no double.
fn in_numbers(
    solution: &Solution,
    case: &Outcome<Value>,
    asked: &[(Quantity, Accept)],
    float: &dyn Fn(&Value) -> Option<f64>,
    tally: &mut Tally,
) -> Option<Result<(), String>> {
    let found = case.turned_into(float)?;
    let again = once_more(&found)?;
    let wrong = |what: &str, found: f64, expected: f64| Some(Err(format!("{what}: {found} and not {expected}")));
    for (found, expected) in found.after.as_flattened().iter().zip(again.after.as_flattened()) {
        if !near(*found, *expected) {
            return wrong("a velocity", *found, *expected);
        }
    }
    if found.e < 0.0 || found.e > 1.0 || found.lost < -1e-9 || !near(found.lost, again.lost) {
        return wrong("energy lost", found.lost, again.lost);
    }
    for (quantity, accept) in asked {
        let Some(expected) = by_definition(*quantity, &again) else { return Some(Err(format!("{quantity}?"))) };
        let (exact, printed) = match (solution.number(*quantity), solution.angle(*quantity)) {
            (Some(value), _) => (float(&value)?, accept.places().map(|places| value.rounded(places))),
            (None, Some(angle)) => (
                float(angle.y())?.atan2(float(angle.x())?).to_degrees(),
                accept.places().map(|places| angle.rounded(places)),
            ),
            (None, None) => return Some(Err(format!("no {quantity}"))),
        };
        if !near(exact, expected) {
            return wrong(&quantity.to_string(), exact, expected);
        }
        tally.answers += 1;
        if let (Some(places), Some(Ok(printed))) = (accept.places(), printed) {
            let printed = printed.to_fraction().to_f64();
            if !rounds_to(printed, places, expected) {
                return wrong(&format!("{quantity}, printed"), printed, expected);
            }
            tally.printed += 1;
        }
    }
    Some(Ok(()))
}

fn asked(question: &Question, style: &Style) -> Vec<(Quantity, Accept)> {
    let answers = question.parts.iter().flat_map(|part| &part.answers);
    answers
        .flat_map(|answer| answer.find.quantities().into_iter().map(|found| (found, answer.accept(style.name).clone())))
        .collect()
}

/// Walks every `share`th set of numbers of every style, and then the random impacts, portion by portion; each of two
/// threads takes the next.
fn walk(
    extent: &Extent,
    styles: &[(&Question, &Style)],
    next: &AtomicU64,
    counts: &Mutex<BTreeMap<String, u64>>,
) -> Tally {
    let mut tally = Tally::default();
    let mine = || next.fetch_add(1, Ordering::Relaxed);
    let mut portion = mine();
    let mut passed = 0;
    for (question, style) in styles {
        let (asked, before) = (asked(question, style), tally.judged + tally.alone);
        let examined = style.size().div_ceil(extent.share);
        while portion < passed + examined.div_ceil(PORTION) {
            let from = (portion - passed) * PORTION;
            for place in from..examined.min(from + PORTION) {
                let Ok(variant) = examine(question, style, place * extent.share) else { continue };
                let mut one =
                    |solution: &Solution, asked: &[(Quantity, Accept)]| match solution.scene().setting.is_of_one() {
                        true => alone::check(solution, asked).map(|()| tally.alone += 1),
                        false => check(solution, asked, &mut tally),
                    };
                let checked = match variant.scene.then.is_empty() {
                    true => one(&variant.solution, &asked),
                    false => later::each_by_itself(&variant.solution, &asked, &mut one),
                };
                if let Err(complaint) = checked {
                    panic!("{complaint}: {}:{} {:?}", question.id, style.name, variant.parameters);
                }
            }
            portion = mine();
        }
        passed += examined.div_ceil(PORTION);
        let judged = tally.judged + tally.alone - before;
        *counts.lock().unwrap().entry(format!("{}:{}", question.id, style.name)).or_default() += judged;
    }
    let asked: Vec<_> = [Quantity::Speed(Sphere::B, Moment::After), Quantity::ImpulseMagnitude]
        .map(|quantity| (quantity, "awrt 3sf".parse().unwrap()))
        .into();
    while portion < passed + extent.random {
        let number = portion - passed;
        let kind = if number % 40 == 0 { Kind::Surd } else { Kind::Rational };
        let scene = random(kind, &mut generator(1000 + number));
        let whole = asked.iter().map(|(quantity, _)| *quantity).collect::<Vec<_>>();
        let checked = scene.solve(&whole).map_err(|refusal| refusal.to_string());
        if let Err(complaint) = checked.and_then(|solution| check(&solution, &asked, &mut tally)) {
            panic!("{complaint}\n{}", scene.json());
        }
        portion = mine();
    }
    tally
}

#[test]
fn carom_knows_a_share_of_its_variants_as_an_independent_judge_does() {
    before_a_judge(&Extent { share: 7, random: 6_500, least: 10_000, least_variants: 4_000 });
}

#[test]
#[ignore = "takes a minute; `.ci/run` runs it"]
fn carom_knows_all_its_variants_as_an_independent_judge_does() {
    before_a_judge(&Extent { share: 1, random: 75_000, least: 100_000, least_variants: 28_000 });
}

fn before_a_judge(extent: &Extent) {
    let bank = Bank::shipped().unwrap_or_else(|_| panic!("the shipped bank reads"));
    let styles: Vec<(&Question, &Style)> =
        bank.questions.iter().flat_map(|question| question.styles.iter().map(move |style| (question, style))).collect();
    let (next, counts) = (AtomicU64::new(0), Mutex::new(BTreeMap::new()));
    let mut total = Tally::default();
    thread::scope(|scope| {
        let workers = [(); 2].map(|()| scope.spawn(|| walk(extent, &styles, &next, &counts)));
        for worker in workers {
            total.add(&worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
    });
    let counts = counts.into_inner().unwrap();
    let variants: u64 = counts.values().sum();
    assert!(variants >= extent.least_variants, "{variants} variants: {counts:#?}");
    assert_eq!(variants + extent.random, total.judged + total.alone, "{total:?}");
    assert!(total.alone > 0, "{total:?}");
    assert!(total.judged >= extent.least, "{total:?}");
    let empty: Vec<&String> = counts.iter().filter(|(_, count)| **count == 0).map(|(name, _)| name).collect();
    assert!(empty.is_empty(), "not one variant of {empty:?}");
    // No check is left out but for reasons that are known: letters have no printed decimals.
    assert_eq!(total.by_other_methods, total.judged, "{total:?}");
    assert!(total.in_fractions > total.judged / 2, "{total:?}");
    assert!(total.with_letters > variants / 50, "{total:?}");
    assert!(total.agreed as u64 > 10 * (total.judged - total.with_letters), "{total:?}");
    assert!(total.answers >= total.judged && total.printed > total.answers / 2, "{total:?}");
    if std::env::var_os("CAROM_COUNTS").is_some() {
        eprintln!("{total:?} {counts:#?}");
    }
}

#[test]
fn carom_knows_that_the_checks_of_its_answers_can_fail() {
    let three = Places::SignificantFigures(3);
    for (printed, value, right) in
        [(2.78, 2.7751, true), (2.77, 2.7751, false), (10.0, 9.996, true), (9.99, 9.996, false), (0.0, 0.0, true)]
    {
        assert_eq!(rounds_to(printed, &three, value), right, "{printed} for {value}");
    }
    assert!(rounds_to(12.3, &Places::DecimalPlaces(1), 12.34) && !rounds_to(12.3, &Places::DecimalPlaces(1), 12.36));
    let scene = random(Kind::Surd, &mut generator(5));
    let asked: Vec<(Quantity, Accept)> = vec![(Quantity::Speed(Sphere::B, Moment::After), "awrt 3sf".parse().unwrap())];
    let solution = scene.solve(&[asked[0].0]).unwrap();
    let mut known = solution.known().clone();
    Derivation::carry_out(&mut known, &whole());
    let right = outcome(solution.scene(), &known).unwrap();
    let judged = |case: &Outcome<Value>| {
        in_numbers(&solution, case, &asked, &|value| value.to_f64(), &mut Tally::default()).unwrap()
    };
    assert_eq!(judged(&right), Ok(()));
    let mut swapped = right.clone();
    swapped.after.swap(0, 1);
    assert!(judged(&swapped).unwrap_err().starts_with("a velocity"));
    let generous = Outcome { lost: &right.lost + &Value::ONE, ..right.clone() };
    assert!(judged(&generous).unwrap_err().starts_with("energy lost"));
    // The judge's own impact of spheres twice as fast: the answer that was given is half of what it finds.
    let double = |pair: &[Value; 2]| pair.each_ref().map(|component| component + component);
    let mut faster = right.clone();
    faster.before = right.before.each_ref().map(double);
    faster.after = right.after.each_ref().map(double);
    faster.lost = &Value::from(4) * &right.lost;
    assert!(judged(&faster).unwrap_err().starts_with("B.after.speed"));
}
