//! The words in which a condition is stated and what was found from it is told.

use super::Line;
use super::later;
use super::refusal::Refusal;
use super::scene::{Condition, Scene};
use super::{Axis, Moment, Quantity, Setting, Sphere};
use crate::expr::{Expr, Relation};
use crate::number::NoRoots;

/// The condition as a teacher says it.
pub(super) fn condition_line(condition: &Condition, scene: &Scene) -> Line {
    let setting = scene.setting;
    let (quantity, other) = (quantity_of(&condition.left), quantity_of(&condition.right));
    let symbols = Symbols::of(condition, scene);
    let line = match quantity {
        Some(Quantity::DeflectionDot(sphere)) if condition.right.is_zero() => Line::with(
            "The path of {A} turns through a right angle, so the scalar product of its velocities before and after is nought.",
            &[("A", Expr::name(sphere.name()))],
            vec![],
        ),
        Some(Quantity::Deflection(sphere)) if condition.right.names().is_empty() => Line::with(
            "It is given that {A} is deflected through {r} degrees.",
            &[("A", Expr::name(sphere.name())), ("r", condition.right.clone())],
            vec![],
        ),
        Some(quantity) if other.is_some() => {
            let other = other.map_or_else(String::new, |other| in_english(other, setting));
            Line::plain(&format!("It is given that {} is equal to {other}.", in_english(quantity, setting)), vec![])
        }
        Some(quantity) => symbols.line(
            &format!("It is given that {} is {{r}}", in_english(quantity, setting)),
            ".",
            &[("r", &condition.right)],
            vec![],
        ),
        None => symbols.line(
            "It is given that {l}",
            ".",
            &[("l", &Expr::equation(condition.left.clone(), condition.right.clone()))],
            vec![],
        ),
    };
    line.said_of(setting)
}

/// The quantity that is the whole of a formula.
fn quantity_of(expr: &Expr) -> Option<Quantity> {
    match expr {
        Expr::Name(name) => name.text.parse().ok(),
        _ => None,
    }
}

/// Symbols for the quantities that stand within the formulas of a condition: a name such as `A.after.ke` is for files.
struct Symbols {
    found: Vec<(Quantity, String)>,
    setting: Setting,
}

impl Symbols {
    fn of(condition: &Condition, scene: &Scene) -> Symbols {
        let is_letter = |name: &str| scene.letters.iter().any(|letter| letter.name() == name);
        let mut found: Vec<(Quantity, String)> = Vec::new();
        for side in [&condition.left, &condition.right].into_iter().filter(|side| quantity_of(side).is_none()) {
            for name in side.names() {
                let Some(quantity) = name.text.parse().ok().filter(|_| !is_letter(&name.text)) else { continue };
                if found.iter().any(|(other, _)| *other == quantity) {
                    continue;
                }
                let is_free = |symbol: &&str| !is_letter(symbol) && !found.iter().any(|(_, other)| other == symbol);
                let symbol = usual(quantity).into_iter().chain(["p", "q", "r", "s", "w", "x", "y", "z"]).find(is_free);
                found.extend(symbol.map(|symbol| (quantity, symbol.to_owned())));
            }
        }
        Symbols { found, setting: scene.setting }
    }

    /// A sentence with formulas in symbols, and what the symbols mean.
    fn line(&self, words: &str, end: &str, formulas: &[(&str, &Expr)], equations: Vec<Expr>) -> Line {
        let meant: Vec<String> = self
            .found
            .iter()
            .map(|(quantity, symbol)| format!("{{{symbol}}} is {}", in_english(*quantity, self.setting)))
            .collect();
        let meant = if meant.is_empty() { String::new() } else { format!(", where {}", meant.join(" and ")) };
        let formulas: Vec<(&str, Expr)> = formulas.iter().map(|(name, expr)| (*name, self.put_in(expr))).collect();
        Line::with(&format!("{words}{meant}{end}"), &formulas, equations)
    }

    fn put_in(&self, expr: &Expr) -> Expr {
        expr.substitute(&|name| {
            let quantity: Quantity = name.parse().ok()?;
            let (_, symbol) = self.found.iter().find(|(other, _)| *other == quantity)?;
            Some(Expr::name(symbol))
        })
    }
}

/// The symbol that a quantity usually has.
fn usual(quantity: Quantity) -> Option<&'static str> {
    Some(match quantity {
        Quantity::Speed(Sphere::A, Moment::After) => "v_A",
        Quantity::Speed(Sphere::B, Moment::After) => "v_B",
        Quantity::Speed(Sphere::A, Moment::Before) => "u_A",
        Quantity::Speed(Sphere::B, Moment::Before) => "u_B",
        Quantity::Mass(Sphere::A) => "m_A",
        Quantity::Mass(Sphere::B) => "m_B",
        Quantity::Restitution => "e",
        _ => return None,
    })
}

/// A quantity in words, as a sentence names it.
pub(super) fn in_english(quantity: Quantity, setting: Setting) -> String {
    use Quantity::*;
    let along = |axis| match axis {
        Axis::X => "along {i}",
        Axis::Y => "along {j}",
        Axis::N => "along the line of centres",
        Axis::T => "perpendicular to the line of centres",
    };
    // In a direct impact what is along the line is the whole.
    let whole = |axis| setting == Setting::Direct && matches!(axis, Axis::X | Axis::N);
    match quantity {
        Mass(s) => format!("the mass of *{}*", s.name()),
        Velocity(s, m, axis) if whole(axis) => format!("the velocity of *{}* {m} the impact", s.name()),
        Velocity(s, m, axis) => {
            format!("the component of the velocity of *{}* {} {m} the impact", s.name(), along(axis))
        }
        Speed(s, m) => format!("the speed of *{}* {m} the impact", s.name()),
        KineticEnergy(s, m) => format!("the kinetic energy of *{}* {m} the impact", s.name()),
        SphereMomentum(s, m, axis) if whole(axis) => format!("the momentum of *{}* {m} the impact", s.name()),
        SphereMomentum(s, m, axis) => {
            format!("the component of the momentum of *{}* {} {m} the impact", s.name(), along(axis))
        }
        AngleToLine(s, m) => format!("the angle in degrees of *{}* to the line of centres {m} the impact", s.name()),
        AngleFromN(s, m) => {
            format!(
                "the angle in degrees, anticlockwise, from the line of centres to the velocity of *{}* {m} the impact",
                s.name()
            )
        }
        AngleFromI(s, m) => {
            format!("the angle in degrees, anticlockwise, from {{i}} to the velocity of *{}* {m} the impact", s.name())
        }
        TanToLine(s, m) => format!("the tangent of the angle of *{}* to the line of centres {m} the impact", s.name()),
        TOverN(s, m) => {
            format!(
                "the component of *{}* perpendicular to the line of centres over the one along it, {m} the impact,",
                s.name()
            )
        }
        AngleToWall(s, m) => {
            format!("the angle in degrees of the path of *{}* with the wall {m} the impact", s.name())
        }
        TanToWall(s, m) => {
            format!("the tangent of the angle of the path of *{}* with the wall {m} the impact", s.name())
        }
        Deflection(s) | SignedDeflection(s) => {
            format!("the angle in degrees through which *{}* is deflected", s.name())
        }
        DeflectionCross(s) => {
            format!("the cross product of the velocities of *{}* before and after the impact", s.name())
        }
        DeflectionDot(s) => {
            format!("the scalar product of the velocities of *{}* before and after the impact", s.name())
        }
        TanDeflection(s) => format!("the tangent of the deflection of *{}*", s.name()),
        Impulse(s, axis) if whole(axis) => format!("the impulse on *{}*", s.name()),
        Impulse(s, axis) => format!("the component of the impulse on *{}* {}", s.name(), along(axis)),
        SphereEnergyLost(s) => format!("the kinetic energy lost by *{}*", s.name()),
        SphereEnergyGained(s) => format!("the kinetic energy gained by *{}*", s.name()),
        ImpulseMagnitude => "the magnitude of the impulse".to_owned(),
        ImpulseAngle => "the acute angle in degrees of the impulse with {i}".to_owned(),
        Approach => "the speed of approach along the line of centres".to_owned(),
        Separation => "the speed of separation along the line of centres".to_owned(),
        Restitution => "the coefficient of restitution".to_owned(),
        MassRatio => "the mass of *B* over that of *A*".to_owned(),
        Line(axis) => format!("the component {} of the unit vector from *A* to *B*", along(axis)),
        Tangent(axis) => format!("the component {} of the unit vector across the line of centres", along(axis)),
        TotalEnergy(m) => format!("the total kinetic energy {m} the impact"),
        EnergyLost => "the kinetic energy lost".to_owned(),
        FractionLost => "the fraction of the kinetic energy lost".to_owned(),
        TotalMomentum(axis) => format!("the component of the total momentum {}", along(axis)),
        AngleBetween(m) => format!("the angle in degrees between the velocities of *A* and *B* {m} the impact"),
        Alpha => "the angle in degrees of the line of centres with the velocity of *A* relative to *B*".to_owned(),
        // No condition can name these.
        GivenDirection(s, m) => format!("the direction of *{}* {m} the impact", s.name()),
        GivenImpulse(axis) => format!("the component of the given impulse {}", along(axis)),
        ContactSine => "the sine of the angle of the line of centres with the path of *A*".to_owned(),
        MomentumEquation => "the equation of momentum".to_owned(),
        RestitutionEquation => "the equation of restitution".to_owned(),
        // As the second impact calls it.
        Later(quantity) => later::numbered(quantity.number(), &in_english(quantity.quantity(), setting)),
        Meeting(_) | InALine => quantity.to_string(),
    }
}

/// Words for a place that prints no markup.
pub(super) fn without_markup(words: &str) -> String {
    words.replace(['*', '{', '}'], "")
}

/// What must be so for something to happen, and the same in the unknown.
pub(super) fn inequality_words(condition: &Condition, inequality: Expr, scene: &Scene) -> Line {
    let to_nought = condition.right.is_zero();
    let must = match condition.relation {
        Relation::Less if to_nought => "must be negative",
        Relation::Greater if to_nought => "must be positive",
        Relation::Less => "must be less than",
        Relation::LessOrEqual => "must be at most",
        Relation::Greater => "must be more than",
        _ => "must be at least",
    };
    let said = |side: &Expr, formula: &str| {
        quantity_of(side).map_or_else(|| formula.to_owned(), |quantity| in_english(quantity, scene.setting))
    };
    let (subject, other) = (said(&condition.left, "{l}"), said(&condition.right, "{r}"));
    let short = to_nought && matches!(condition.relation, Relation::Less | Relation::Greater);
    // Two velocities in one line are compared with their signs.
    let is_velocity = |side: &Expr| {
        quantity_of(side).is_some_and(|quantity| matches!(quantity.of_its_impact(), Quantity::Velocity(..)))
    };
    let signs = if scene.setting == Setting::Direct && is_velocity(&condition.left) && is_velocity(&condition.right) {
        ", both positive from *A* towards *B*"
    } else {
        ""
    };
    let subject = capitalised(&subject);
    let words = if short { format!("{subject} {must}") } else { format!("{subject} {must} {other}{signs}") };
    let formulas = [("r", &condition.right), ("l", &condition.left)];
    Symbols::of(condition, scene).line(&words, ":", &formulas, vec![inequality]).said_of(scene.setting)
}

fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A condition on what no impact of the scene has.
pub(super) fn of_no_impact(quantity: Quantity, impacts: usize) -> Refusal {
    let has = if impacts == 1 { "there is one".to_owned() } else { format!("there are {impacts}") };
    let reason = format!("a condition speaks of `{quantity}`, of an impact that the scene does not have: {has}");
    Refusal::underdetermined(reason)
        .try_this(format!("write `{}`, or add the impact in `then`", quantity.of_its_impact()))
}

/// Why a system was not solved, in words.
pub(super) fn no_roots(reason: NoRoots) -> Refusal {
    match reason {
        NoRoots::Always => {
            Refusal::underdetermined("the conditions leave the unknowns open: one of them adds nothing to the others")
                .try_this("give in its place a condition on a quantity that depends on the other unknown")
        }
        NoRoots::Never => Refusal::impossible("the conditions contradict each other")
            .try_this("leave one of the conditions out, or give another value in it"),
        NoRoots::Degree(degree) => Refusal::beyond(format!(
            "the conditions lead to an equation of degree {degree}; only linear and quadratic ones, in an unknown or its square, are solved"
        )),
        NoRoots::TooLong => Refusal::beyond("the conditions lead to formulas too long to be solved exactly"),
    }
}

/// What to do where the conditions leave open what is to be found.
pub(super) const CONDITION_THAT_TELLS: &str =
    "give as many conditions as unknowns, each on a quantity that depends on them, such as `A.after.speed = 3`";

/// How to say what is to be found, if it is a letter of the scene: *e* if that is one, for it is asked for most.
pub(super) fn name_the_unknown(scene: &Scene) -> String {
    let named = scene.letters.iter().find(|letter| letter.name() == "e").or(scene.letters.first());
    let example = named.map(|letter| format!(", such as `[\"{}\"]`", letter.name()));
    format!("name what is to be found in `unknowns`{}", example.unwrap_or_default())
}
