//! What looking through working needs of a question, made once for all its scripts.

use super::elsewhere::Elsewhere;
use super::equations::{Critical, Laws, given_numbers};
use super::examine::value;
use super::laws::along_for;
use super::numbers::{Points, sizes};
use super::theirs::numbers;
use crate::bank::{EarnedFor, Find};
use crate::expr::Expr;
use crate::mechanics::{
    Axis, Contact, Datum, Derivation, Known, Meeting, Moment, Quantity, Rule, Scene, Setting, Sphere, Velocity,
};
use crate::number::{Letter, Places, Range, Value, round};

/// A question made ready for the working of its students.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// What the impact is between.
    pub(super) setting: Setting,
    pub(super) points: Points,
    /// Everything that a solution may touch on, at every point.
    pub(super) known: Vec<Known<f64>>,
    /// What is given, at every point.
    pub(super) given: Vec<Known<f64>>,
    pub(super) laws: Option<Laws>,
    /// The coefficient of restitution as it is given.
    pub(super) restitution: Option<Expr>,
    /// The laws where the condition of a range changes from one side to the other.
    pub(super) critical: Option<Critical>,
    /// Are the velocities before given by numbers for their components?
    pub(super) in_components: bool,
    /// Names under which students write what is given as a number.
    pub(super) names: Vec<(String, Vec<f64>)>,
    /// The angles to which its words give a name, in degrees; and α, which the solution calls that of the path with the line of
    /// centres, where the words give its distance from a centre.
    pub(super) angles: Vec<(String, f64)>,
    /// The angle of the path with the line of centres, in degrees, if that has first to be found from the distance.
    pub(super) from_distance: Option<f64>,
    /// The decimals of the question.
    pub(super) decimals: Vec<String>,
    /// The numbers that it gives for masses and velocities.
    pub(super) given_numbers: Vec<Expr>,
    /// The letters that it gives for speeds.
    pub(super) letters_of_speeds: Vec<String>,
    /// The velocities with which a later impact begins, as numbers, where the question does not give them.
    pub(super) carried: Vec<Expr>,
    /// What is given for other impacts too.
    elsewhere: Elsewhere,
    /// The sizes of the velocities of earlier impacts.
    speeds_elsewhere: Vec<f64>,
    /// Where letters were to be found: those letters with their values at every point where they have one.
    pub(super) found: Vec<(Letter, Vec<Option<f64>>)>,
    /// What is known there.
    there: Vec<Option<Known<f64>>>,
}

impl Prepared {
    /// Prepares a question with these letters, whose scene gives this, and from which this is to be found.
    pub fn new(
        scene: &Scene,
        letters: &[Letter],
        exact: &Known<Value>,
        found: &[(Letter, Value)],
        decimals: Vec<String>,
        angles: Vec<(String, f64)>,
        elsewhere: Elsewhere,
    ) -> Prepared {
        let (points, mut angles) = (Points::new(letters), angles);
        let given: Vec<Known<f64>> = (0..points.count).map(|point| points.known(exact, point)).collect();
        let known = given.iter().map(complete).collect::<Vec<_>>();
        let named = [
            (Quantity::Restitution, &["e"][..]),
            (Quantity::Mass(Sphere::A), &["m_A", "m_1"]),
            (Quantity::Mass(Sphere::B), &["m_B", "m_2"]),
        ];
        let is_from_distance = matches!(scene.contact, Some(Contact::Offset { .. }));
        let angle = sizes(&known, Quantity::AngleToLine(Sphere::A, Moment::Before)).filter(|_| is_from_distance);
        let from_distance =
            angle.filter(|angle| angle.iter().all(|at| (at - angle[0]).abs() < 1e-9)).map(|angle| angle[0]);
        if angles.iter().all(|(name, _)| name != "alpha") {
            angles.extend(from_distance.map(|angle| ("alpha".to_owned(), angle)));
        }
        let mut names = Vec::new();
        for (quantity, letters) in named {
            if let Some(sizes) = sizes(&known, quantity) {
                names.extend(letters.iter().map(|letter| ((*letter).to_owned(), sizes.clone())));
            }
        }
        let found = found
            .iter()
            .map(|(letter, value)| (*letter, (0..points.count).map(|point| points.value(value, point)).collect()));
        let found: Vec<(Letter, Vec<Option<f64>>)> = found.collect();
        let there = (0..points.count).map(|point| {
            let has_values = !found.is_empty() && found.iter().all(|(_, values)| values[point].is_some());
            has_values.then(|| complete(&points.with(&found, point).known(exact, point)))
        });
        let there = there.collect();
        // A later impact begins with what the one before has left, in letters or not.
        let is_in_letters = |(quantity, datum): (&Quantity, &Datum<Value>)| match (quantity, datum) {
            (Quantity::Velocity(_, Moment::Before, _), Datum::Number(size)) => !size.is_constant(),
            _ => false,
        };
        let in_components = scene.before.iter().flatten().all(|velocity| match velocity {
            Velocity::Components(x, y) => x.value.is_constant() && y.value.is_constant(),
            Velocity::Polar { .. } => false,
        }) && !exact.0.iter().any(is_in_letters);
        let letters_of_speeds = scene.before.iter().flatten().flat_map(|velocity| match velocity {
            Velocity::Components(x, y) => [x.value.letters(), y.value.letters()].concat(),
            Velocity::Polar { speed, .. } => speed.value.letters(),
        });
        let mut speeds: Vec<Letter> = letters_of_speeds.filter(|letter| letter.range() == Range::Positive).collect();
        speeds.sort();
        speeds.dedup();
        let letters_of_speeds = speeds.iter().map(|letter| letter.name().to_owned()).collect();
        let at_points = |letter: &Letter| (0..points.count).map(|at| points.letter(letter.name(), at)).collect();
        let laws = Laws::of(&given[0], &known, in_components, speeds.iter().filter_map(at_points).collect());
        let speeds_elsewhere = elsewhere.speeds(&points);
        let mut prepared = Prepared {
            setting: scene.setting,
            points,
            known,
            given,
            laws,
            restitution: scene.restitution.as_ref().map(|given| given.shown.clone()),
            critical: None,
            in_components,
            names,
            angles,
            from_distance,
            decimals,
            given_numbers: given_numbers(scene),
            letters_of_speeds,
            carried: elsewhere.carried(),
            speeds_elsewhere,
            elsewhere,
            found,
            there,
        };
        let others: Vec<Vec<f64>> =
            prepared.elsewhere.restitutions.iter().filter_map(|given| prepared.sizes_of(given)).collect();
        prepared.laws = prepared.laws.map(|laws| laws.beside(&others));
        prepared.critical = Critical::of(scene, &prepared);
        prepared
    }
}

impl Prepared {
    /// A wrong value of one quantity, and what then follows for another.
    pub(crate) fn followed_value(&self, own: Quantity, asked: Quantity) -> Option<(String, f64)> {
        let ([given], [known]) = (self.given.as_slice(), self.known.as_slice()) else { return None };
        let right = known.number(own)?;
        let wrong =
            round(&format!("{:.9}", 1.3 * right + 0.2).parse().ok()?, &Places::SignificantFigures(3)).to_string();
        let mut from = given.clone();
        from.0.insert(own, Datum::Number(wrong.parse().ok()?));
        let answer = complete(&from).number(asked)?;
        ((answer - known.number(asked)?).abs() > 0.02 * answer.abs()).then_some((wrong, answer))
    }

    /// Are the masses of the two spheres equal, so that momentum does not tell which is which?
    pub(super) fn has_equal_masses(&self) -> bool {
        let [one, other] = Sphere::BOTH.map(|sphere| sizes(&self.known, Quantity::Mass(sphere)));
        one.is_some() && one == other
    }

    /// Are both numbers masses, so that one in the place of the other is a mistake and no slip of the pen?
    pub(super) fn are_masses(&self, one: &Expr, other: &Expr) -> bool {
        self.elsewhere.masses.contains(one) && self.elsewhere.masses.contains(other)
    }

    /// Is it the size of a velocity of an earlier impact, before it or after it?
    pub(super) fn is_speed_elsewhere(&self, number: &Expr) -> bool {
        let size = self.sizes_of(number).and_then(|sizes| sizes.first().copied());
        size.is_some_and(|size| self.speeds_elsewhere.iter().any(|own| (own - size.abs()).abs() < 1e-9))
    }

    /// Is it the coefficient of restitution of some impact?
    pub(super) fn is_restitution_elsewhere(&self, number: &Expr) -> bool {
        let sizes = self.sizes_of(number);
        sizes.is_some() && self.elsewhere.restitutions.iter().any(|given| self.sizes_of(given) == sizes)
    }

    /// The letter that was to be found, where this quantity is given as that letter.
    pub(crate) fn letter_of(&self, quantity: Quantity) -> Option<String> {
        let given = sizes(&self.given, quantity)?;
        let is_it = |letter: &Letter| {
            let mut at = given.iter().enumerate();
            at.all(|(point, size)| {
                self.points.letter(letter.name(), point).is_some_and(|own| (own - size).abs() < 1e-9)
            })
        };
        self.found.iter().map(|(letter, _)| letter).find(|letter| is_it(letter)).map(|letter| letter.name().to_owned())
    }

    /// Does the question give what has this name: by a letter of its own, or as a number?
    pub(super) fn gives(&self, name: &str) -> bool {
        self.points.letter(name, 0).is_some() || self.names.iter().any(|(known, _)| known == name)
    }

    /// What a formula comes to at every point, if it is a number and has no unknowns.
    pub(super) fn sizes_of(&self, expr: &Expr) -> Option<Vec<f64>> {
        numbers(&value(expr, self, &self.names)?)
    }

    /// The component along the line of centres that a component along i or j is, where that is its direction.
    pub(crate) fn along(&self, quantity: Quantity) -> Quantity {
        along_for(quantity, self)
    }

    /// The right value of a quantity at every point.
    pub(crate) fn known_sizes(&self, quantity: Quantity) -> Option<Vec<f64>> {
        sizes(&self.known, quantity)
    }

    /// Would an answer be another if the step that earns a mark were wrong? Its result is changed by a few hundredths to
    /// see; what is nought stays nought. Numbers may hide it by chance, as where *A* leaves with the velocity that *B* had: so
    /// it is tried with others too.
    pub(crate) fn is_needed(&self, step: &EarnedFor, find: &Find) -> bool {
        let asked = find.quantities();
        if asked.is_empty() || matches!(step, EarnedFor::Condition | EarnedFor::Unknown(_)) {
            return true;
        }
        let given = &self.given[0];
        self.is_needed_from(given, step, &asked) || self.is_needed_from(&with_other_numbers(given), step, &asked)
    }

    /// The same, from what is given.
    fn is_needed_from(&self, given: &Known<f64>, step: &EarnedFor, asked: &[Quantity]) -> bool {
        let mut right = given.clone();
        let (derivation, _) = Derivation::carry_out(&mut right, asked);
        let along: Vec<Quantity> = step.quantities().iter().map(|quantity| along_for(*quantity, self)).collect();
        let is_step = |rule: &Rule, quantity: Quantity| match step {
            EarnedFor::Law(law, sphere) => {
                let about = rule.gives.first().and_then(|gives| gives.of_its_impact().sphere());
                rule.law == *law && (sphere.is_none() || about.is_none() || about == *sphere)
            }
            value => value.quantities().contains(&quantity) || along.contains(&quantity),
        };
        // On another way to the answer nothing can be told.
        let on_the_way = |rule: &Rule| rule.gives.iter().any(|quantity| is_step(rule, *quantity));
        if !derivation.steps.iter().any(|rule| on_the_way(rule)) {
            return true;
        }
        let mut wrong = given.clone();
        let mut results = 0;
        for rule in &derivation.steps {
            for (quantity, datum) in rule.gives.iter().zip(rule.evaluate(&wrong).unwrap_or_default()) {
                results += 1;
                let datum = match (is_step(rule, *quantity), datum) {
                    // A value that is nought could have been another.
                    (true, Datum::Number(0.0)) if !along.is_empty() => Datum::Number(0.1),
                    (true, datum) => changed(datum, results),
                    (false, datum) => datum,
                };
                wrong.0.insert_new(*quantity, datum);
            }
        }
        let at = |known: &Known<f64>, quantity| sizes(std::slice::from_ref(known), quantity).map(|sizes| sizes[0]);
        asked.iter().any(|quantity| match at(&right, *quantity).zip(at(&wrong, *quantity)) {
            Some((right, wrong)) => (right - wrong).abs() > 1e-9 * right.abs().max(1e-3),
            None => true,
        })
    }

    /// What is known at a point where the letters that were to be found are what was found.
    pub(super) fn where_found(&self, point: usize) -> Option<&Known<f64>> {
        self.there[point].as_ref()
    }

    /// The same at every point, if letters were to be found and have values everywhere.
    pub(super) fn all_where_found(&self) -> Option<Vec<Known<f64>>> {
        self.there.iter().cloned().collect()
    }
}

/// Something else, by a few hundredths; each result by another part, so that none cancels another.
fn changed(datum: Datum<f64>, place: usize) -> Datum<f64> {
    match datum {
        Datum::Number(number) => Datum::Number((1.07 + 0.06 * place as f64) * number),
        Datum::Direction { y, x } => Datum::Direction { y: 1.07 * y, x },
        Datum::Equation([p, q, r]) => Datum::Equation([p, 1.07 * q, 1.11 * r]),
    }
}

/// The same with other masses, another *e* and other velocities, each changed by another part.
fn with_other_numbers(given: &Known<f64>) -> Known<f64> {
    use Quantity::{Mass, Restitution, Speed, Velocity};
    let mut other = given.clone();
    for (place, (quantity, datum)) in given.0.iter().enumerate() {
        if matches!(quantity.of_its_impact(), Mass(_) | Restitution | Velocity(..) | Speed(..)) {
            other.0.insert(*quantity, changed(datum.clone(), place));
        }
    }
    other
}

/// All that follows from what is known.
pub(super) fn complete(known: &Known<f64>) -> Known<f64> {
    let mut all = known.clone();
    let mut asked = wanted();
    for meeting in Meeting::all(known.0.keys()) {
        asked.extend(wanted().into_iter().map(|quantity| meeting.quantity(quantity)));
    }
    Derivation::carry_out(&mut all, &asked);
    all
}

/// What a student may write down on the way to any answer.
fn wanted() -> Vec<Quantity> {
    let mut wanted = Vec::new();
    for sphere in Sphere::BOTH {
        for moment in [Moment::Before, Moment::After] {
            wanted.extend([Axis::N, Axis::T, Axis::X, Axis::Y].map(|axis| Quantity::Velocity(sphere, moment, axis)));
            wanted.push(Quantity::Speed(sphere, moment));
            wanted.push(Quantity::KineticEnergy(sphere, moment));
            wanted.push(Quantity::AngleToLine(sphere, moment));
            wanted.push(Quantity::TOverN(sphere, moment));
        }
        wanted.push(Quantity::Mass(sphere));
        wanted.push(Quantity::Deflection(sphere));
        wanted.push(Quantity::TanDeflection(sphere));
        wanted.push(Quantity::DeflectionDot(sphere));
        wanted.push(Quantity::Impulse(sphere, Axis::N));
        wanted.extend([Quantity::SphereEnergyLost(sphere), Quantity::SphereEnergyGained(sphere)]);
    }
    let both = [Quantity::TotalEnergy(Moment::Before), Quantity::TotalEnergy(Moment::After), Quantity::EnergyLost];
    wanted.extend(both);
    wanted.extend([Quantity::FractionLost, Quantity::ImpulseMagnitude, Quantity::Restitution]);
    wanted.extend([Quantity::Line(Axis::X), Quantity::Line(Axis::Y), Quantity::ContactSine]);
    wanted.extend([Quantity::MomentumEquation, Quantity::RestitutionEquation]);
    wanted
}
