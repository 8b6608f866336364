//! For which values of an unknown something happens: 'the set of values of e for which A turns back'.
//!
//! The collision is derived forwards with the unknown as a letter. Each condition is then an inequality in it, and so is
//! everything without which there is no collision: the masses are positive, the spheres approach, they do not pass through
//! each other, and e lies between 0 and 1.

use super::backwards::Posed;
use super::condition::{are_unsigned_angles, name_of, residual};
use super::conditions_in_words::{inequality_words, no_roots};
use super::later::Meeting;
use super::line::Line;
use super::refusal::Refusal;
use super::scene::{Condition, Contact};
use super::scene_reader::meaning;
use super::sought::Vanishing;
use super::working::Show;
use super::{Derivation, Quantity, Sphere, pose};
use crate::expr::{Expr, Relation, number, print, written};
use crate::number::{Demand, End, Letter, NoRoots, Range, Span, Value, solve_inequalities};

/// The values of an unknown for which the conditions hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The unknown.
    pub letter: Letter,
    /// From where to where.
    pub span: Span,
}

impl Values {
    /// `1/3 < e ≤ 1`, or `k > 2`.
    pub fn written(&self) -> Expr {
        let name = Expr::name(self.letter.name().replace("A.mass", "m_A").replace("B.mass", "m_B"));
        let relation = |included: bool, strict, weak| if included { weak } else { strict };
        match (&self.span.low, &self.span.high) {
            (Some(low), Some(high)) => {
                let first = relation(low.included, Relation::Less, Relation::LessOrEqual);
                let second = relation(high.included, Relation::Less, Relation::LessOrEqual);
                let left = Expr::Relation(Box::new(written(&low.value)), first, Box::new(name));
                Expr::Relation(Box::new(left), second, Box::new(written(&high.value)))
            }
            (Some(low), None) => {
                let first = relation(low.included, Relation::Greater, Relation::GreaterOrEqual);
                Expr::Relation(Box::new(name), first, Box::new(written(&low.value)))
            }
            (None, Some(high)) => {
                let second = relation(high.included, Relation::Less, Relation::LessOrEqual);
                Expr::Relation(Box::new(name), second, Box::new(written(&high.value)))
            }
            (None, None) => name,
        }
    }

    /// The ends but for those of what the letter may be at all, which need no reason.
    fn ends_found(&self) -> impl Iterator<Item = &End> {
        let domain = Span::of(self.letter.range());
        let is_of_letter =
            move |end: &&End| domain.low.iter().chain(&domain.high).any(|other| other.value.equals(&end.value));
        self.span.low.iter().chain(&self.span.high).filter(move |end| !is_of_letter(end))
    }
}

impl Condition {
    /// Is it an inequality?
    pub fn is_inequality(&self) -> bool {
        self.relation != Relation::Equal
    }
}

/// The set of values of the one unknown.
///
/// # Errors
///
/// More than one unknown, equations beside inequalities, more given than the impact needs, values that are not from one
/// number to another, none or all of them, or inequalities beyond the methods of an exam.
pub(super) fn values(posed: &Posed) -> Result<Values, Refusal> {
    let scene = &posed.scene;
    let [unknown] = scene.unknowns.as_slice() else {
        return Err(Refusal::beyond("an inequality is solved for one unknown only"));
    };
    if scene.maximise.is_some() || !scene.conditions.iter().all(Condition::is_inequality) {
        return Err(Refusal::beyond("inequalities beside equations or `maximise` are not solved here"));
    }
    if unknown.range() == Range::Acute {
        return Err(Refusal::beyond("a range of angles is not found here").try_this("ask for a range of its tangent"));
    }
    not_determined_already(posed, *unknown)?;
    approached_from_one_side(posed, *unknown)?;
    let stated = posed.stated()?;
    let physical = posed.physical();
    let demands: Vec<(Value, Demand)> =
        physical.iter().map(Physical::demanded).chain(stated.into_iter().map(|one| one.demanded)).collect();
    let name = unknown.name();
    let others = demands.iter().flat_map(|(value, _)| value.letters()).find(|letter| letter != unknown);
    let mut spans = solve_inequalities(&demands, *unknown).map_err(|reason| match (reason, others) {
        // Which of two ends is the further one, nobody can say of letters.
        (NoRoots::TooLong, Some(other)) => {
            let other = other.name();
            Refusal::beyond(format!("a range of {name} with ends in terms of {other} is not found here"))
                .try_this(format!("let {other} be a parameter, with numbers for values"))
        }
        (reason, _) => no_roots(reason),
    })?;
    match spans.len() {
        0 => return Err(Refusal::impossible(format!("the conditions hold for no value of {name}"))),
        1 if spans[0] == Span::of(unknown.range()) => {
            let holds = Refusal::underdetermined(format!("the conditions hold whatever {name} is"));
            return Err(holds.try_this("give a condition that only some values meet, such as `A.after.n < 0`"));
        }
        1 => match (&spans[0].low, &spans[0].high) {
            (Some(low), Some(high)) if low.value.equals(&high.value) => {
                let value = print::unicode(&written(&low.value));
                let refusal = Refusal::beyond(format!("the conditions hold for one value of {name} alone, {value}"));
                return Err(refusal.try_this("give an equation as the condition, and ask for the value"));
            }
            _ => {}
        },
        _ => {
            let are_parted_by_a_point = spans.windows(2).all(|pair| match (&pair[0].high, &pair[1].low) {
                (Some(high), Some(low)) => high.value.equals(&low.value),
                _ => false,
            });
            let names = scene.conditions.iter().flat_map(|one| [&one.left, &one.right]).flat_map(Expr::names);
            let tangent = names.filter_map(|name| name.text.parse().ok()).find_map(|tangent: Quantity| {
                let angle = match tangent.of_its_impact() {
                    Quantity::TanToLine(sphere, moment) => Quantity::AngleToLine(sphere, moment),
                    Quantity::TanToWall(sphere, moment) => Quantity::AngleToWall(sphere, moment),
                    _ => return None,
                };
                Some((tangent, angle.in_impact(tangent.impact())?))
            });
            let all = spans.drain(..).map(|span| Values { letter: *unknown, span });
            let all: Vec<String> = all.map(|values| print::unicode(&values.written())).collect();
            let pieces = Refusal::beyond(format!("the values of {name} are not in one piece: {}", all.join(", or ")));
            return Err(match tangent.filter(|_| are_parted_by_a_point) {
                Some((tangent, angle)) => pieces.try_this(format!(
                    "there is no `{tangent}` at a right angle: write the condition with `{angle}`, as in `{angle} > atan(2)/deg`"
                )),
                None => pieces.try_this("give one more condition, which only one of the pieces meets"),
            });
        }
    }
    Ok(Values { letter: *unknown, span: spans.remove(0) })
}

/// Where more is given than an impact needs, a law determines the unknown by itself, and there is no range of it.
fn not_determined_already(posed: &Posed, unknown: Letter) -> Result<(), Refusal> {
    if posed.broken.iter().any(|law| law.difference.has_letter(|letter| *letter == unknown)) {
        let name = unknown.name();
        return Err(Refusal::beyond(format!("more is given than the impact needs: the laws alone determine {name}"))
            .try_this(format!(
                "leave out the inequality, and {name} is found; or leave out a velocity after the impact"
            )));
    }
    match posed.broken.first() {
        Some(law) => Err(Refusal::impossible(law.reason.clone())),
        None => Ok(()),
    }
}

/// Where no sense of the line of centres is given it points as the bodies approach. If that depends on the unknown, the
/// set of values has a part for either way, and only one would be found.
fn approached_from_one_side(posed: &Posed, unknown: Letter) -> Result<(), Refusal> {
    let first = (Meeting::FIRST, &posed.scene);
    for (meeting, scene) in
        std::iter::once(first).chain(posed.scene.then.iter().map(|then| (then.meeting, &then.scene)))
    {
        let approach = meeting.quantity(Quantity::Approach);
        let mut known = posed.known.clone();
        Derivation::carry_out(&mut known, &[approach]);
        let is_open = |value: &Value| value.has_letter(|letter| *letter == unknown) && value.sign().is_none();
        let has_sense = !matches!(scene.contact, Some(Contact::Along(_, _, None)));
        if !has_sense && known.number(approach).as_ref().is_some_and(is_open) {
            let name = unknown.name();
            let refusal = Refusal::beyond(format!("from which side the bodies approach depends on {name}"));
            let help = "give `sense`, or, at a wall, a velocity whose sign does not depend on the letter";
            return Err(refusal.try_this(help));
        }
    }
    Ok(())
}

/// A condition as an inequality in the unknown.
struct Stated {
    /// Both sides as they were found, where they are numbers.
    sides: [Value; 2],
    demanded: (Value, Demand),
}

/// Something without which there is no collision.
struct Physical {
    /// Of what it is demanded.
    quantity: Quantity,
    value: Value,
    /// From which side of this number the value must lie.
    bound: Value,
    relation: Relation,
}

impl Physical {
    fn demanded(&self) -> (Value, Demand) {
        match self.relation {
            Relation::Greater => (&self.value - &self.bound, Demand::Positive),
            Relation::LessOrEqual => (&self.bound - &self.value, Demand::NotNegative),
            _ => (&self.value - &self.bound, Demand::NotNegative),
        }
    }

    /// Is it what ends the range there?
    fn ends_at(&self, letter: Letter, end: &End) -> bool {
        let (value, demand) = self.demanded();
        ends_at(&value, demand, letter, end)
    }

    /// What it is, and the inequality that it leads to.
    fn line(&self) -> Line {
        let words = match (self.quantity, self.relation) {
            (Quantity::Mass(Sphere::A), _) => "The mass of *A* is positive:",
            (Quantity::Mass(Sphere::B), _) => "The mass of *B* is positive:",
            (Quantity::MassRatio, _) => "Both masses are positive, and so is the mass of *B* over that of *A*:",
            (Quantity::Approach, _) => {
                "The spheres approach each other before the impact, so the speed of approach is positive:"
            }
            (Quantity::Restitution, Relation::LessOrEqual) => "The coefficient of restitution is at most 1:",
            (Quantity::Restitution, _) => "The coefficient of restitution is not negative:",
            _ => "The spheres do not pass through each other, so the speed of separation is not negative:",
        };
        let inequality = Expr::Relation(Box::new(written(&self.value)), self.relation, Box::new(written(&self.bound)));
        Line::plain(words, vec![inequality])
    }
}

fn ends_at(value: &Value, demand: Demand, letter: Letter, end: &End) -> bool {
    let allows = demand == Demand::NotNegative || !end.included;
    allows && value.substitute(letter, &end.value).is_some_and(|there| there.is_zero())
}

/// The forward derivation in letters, each condition as an inequality, what else ends the range, and what follows.
pub(super) fn lines(posed: &Posed, values: &Values) -> Vec<Line> {
    // They have been found once, or there would be no values.
    let stated = posed.stated().unwrap_or_default();
    let physical = posed.physical();
    let because = values.ends_found().filter_map(|end| {
        let is_stated =
            stated.iter().any(|Stated { demanded: (value, demand), .. }| ends_at(value, *demand, values.letter, end));
        physical.iter().find(|physical| !is_stated && physical.ends_at(values.letter, end))
    });
    let because: Vec<&Physical> = because.collect();
    // What a line speaks of is derived first, even if no condition speaks of it.
    let asked: Vec<Quantity> = posed.asked.iter().copied().chain(because.iter().map(|one| one.quantity)).collect();
    let mut known = pose(&posed.scene).unwrap_or_default();
    let (derivation, _) = Derivation::carry_out(&mut known, &asked);
    let show = Show::new(&posed.scene, &known, &asked);
    let mut lines: Vec<Line> = derivation.steps.iter().flat_map(|step| step.lines(&show)).collect();
    for (condition, Stated { sides: [left, right], .. }) in posed.scene.conditions.iter().zip(&stated) {
        let inequality = Expr::Relation(Box::new(written(left)), condition.relation, Box::new(written(right)));
        lines.push(inequality_words(condition, inequality, &posed.scene).of_condition(&posed.scene));
    }
    // `Between 0 and 1` is one condition, though only one end of it had to be said.
    let is_of_conditions = |quantity: Quantity| {
        let names = posed.scene.conditions.iter().flat_map(|condition| [&condition.left, &condition.right]);
        names.flat_map(Expr::names).any(|name| name.text == quantity.to_string())
    };
    lines.extend(
        because.into_iter().map(|one| Line {
            of_condition: is_of_conditions(one.quantity),
            ..one.line().said_of(posed.scene.setting)
        }),
    );
    let is_end = |end: &Option<End>, at: &Value| end.as_ref().is_some_and(|end| end.included && end.value.equals(at));
    let of_e = values.letter.range() == Range::Unit;
    let words = if of_e && is_end(&values.span.high, &Value::ONE) {
        "A coefficient of restitution is at most 1, so"
    } else if of_e && is_end(&values.span.low, &Value::ZERO) {
        "A coefficient of restitution is not negative, so"
    } else {
        "So"
    };
    lines.push(Line::plain(words, vec![values.written()]));
    lines.into_iter().map(Line::with_masses_in_symbols).collect()
}

impl Posed {
    /// The ends of a range, each with what is nought there. What a letter may be at all is no end that was found.
    pub(super) fn ends(&self, values: &Values) -> Vec<(Value, Vanishing)> {
        let (stated, physical) = (self.stated().unwrap_or_default(), self.physical());
        let conditions = || self.scene.conditions.iter().zip(&stated);
        let found = |end: &End| {
            let vanishing = conditions().find_map(|(condition, Stated { demanded: (value, demand), .. })| {
                ends_at(value, *demand, values.letter, end).then(|| Vanishing::Gap(condition.clone()))
            });
            let bound = || {
                let bounds = physical.iter().find(|physical| physical.ends_at(values.letter, end))?;
                Some(Vanishing::Distance(bounds.quantity, bounds.bound.clone()))
            };
            Some((end.value.clone(), vanishing.or_else(bound)?))
        };
        values.ends_found().filter_map(found).collect()
    }

    /// The conditions as inequalities.
    fn stated(&self) -> Result<Vec<Stated>, Refusal> {
        let letters = |name: &str| meaning(&self.scene.letters, name);
        let one = |condition: &Condition| {
            let gap = residual(condition, &letters, &self.known).map_err(super::condition::fault)?;
            if gap.is_of_angles() && !are_unsigned_angles(condition, &letters) {
                return Err(Refusal::beyond("an inequality between these angles is not solved here")
                    .try_this("compare an angle that has no sign with a number of degrees from 0 to 180"));
            }
            let side = |expr: &Expr| number(expr, &|name| name_of(name, &letters, &self.known)).ok();
            let sides = side(&condition.left).zip(side(&condition.right));
            let (left, right) = sides.unwrap_or((gap.value.clone(), Value::ZERO));
            let demanded = match condition.relation {
                Relation::Greater => (gap.value, Demand::Positive),
                Relation::GreaterOrEqual => (gap.value, Demand::NotNegative),
                Relation::Less => (-gap.value, Demand::Positive),
                _ => (-gap.value, Demand::NotNegative),
            };
            Ok(Stated { sides: [left, right], demanded })
        };
        self.scene.conditions.iter().map(one).collect()
    }

    /// What must hold for there to be a collision at all, as far as it depends on the unknown.
    fn physical(&self) -> Vec<Physical> {
        let of_one = [
            (Quantity::Mass(Sphere::A), Relation::Greater, Value::ZERO),
            (Quantity::Mass(Sphere::B), Relation::Greater, Value::ZERO),
            (Quantity::MassRatio, Relation::Greater, Value::ZERO),
            (Quantity::Approach, Relation::Greater, Value::ZERO),
            (Quantity::Restitution, Relation::GreaterOrEqual, Value::ZERO),
            (Quantity::Restitution, Relation::LessOrEqual, Value::ONE),
            (Quantity::Separation, Relation::GreaterOrEqual, Value::ZERO),
        ];
        let mut demands = of_one.to_vec();
        for meeting in Meeting::all(self.known.0.keys()) {
            let later = of_one
                .iter()
                .map(|(quantity, relation, bound)| (meeting.quantity(*quantity), *relation, bound.clone()));
            demands.extend(later);
        }
        // Of masses that are known and positive no ratio needs to be derived from what they do.
        let are_known = |ratio: Quantity| {
            let masses = Sphere::BOTH.map(|sphere| Quantity::Mass(sphere).in_impact(ratio.impact()));
            masses.iter().all(|mass| mass.is_some_and(|mass| self.known.0.contains_key(&mass)))
        };
        demands.retain(|(quantity, ..)| quantity.of_its_impact() != Quantity::MassRatio || !are_known(*quantity));
        let mut known = self.known.clone();
        Derivation::carry_out(&mut known, &demands.iter().map(|(quantity, ..)| *quantity).collect::<Vec<_>>());
        let open = |value: &Value| value.has_letter(|letter| self.scene.unknowns.contains(letter));
        let one = |(quantity, relation, bound)| {
            let value = known.number(quantity).filter(open)?;
            Some(Physical { quantity, value, bound, relation })
        };
        demands.into_iter().filter_map(one).collect()
    }
}
