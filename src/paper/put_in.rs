//! Once a letter is found, what was worked out in terms of it is not worked out again: its value is put in.

use super::working::Step;
use crate::expr::{Expr, written, written_angle};
use crate::mechanics::{
    Axis, Datum, Derivation, Known, Line, Moment, Quantity, Rule, Scene, Show, broken_laws, demanding, pose,
    with_letters,
};
use crate::number::{Angle, Letter, Range, Value};

/// What was worked out in terms of letters before they were found.
pub struct InLetters {
    /// The steps that led to the conditions.
    pub rules: Vec<&'static Rule>,
    scene: Scene,
    known: Known<Value>,
    asked: Vec<Quantity>,
    found: Vec<(Letter, Value)>,
}

impl InLetters {
    /// The steps from a scene with unknown letters to the quantities of its conditions. Nothing if it cannot be posed.
    pub fn of(scene: &Scene, found: &[(Letter, Value)]) -> Option<InLetters> {
        let scene = with_letters(scene);
        let mut known = pose(&scene).ok()?;
        let sides = scene.conditions.iter().flat_map(|condition| [&condition.left, &condition.right]);
        let named = sides.flat_map(Expr::names).filter_map(|name| name.text.parse().ok());
        let asked: Vec<Quantity> = named.chain(scene.maximise).collect();
        let (mut derivation, _) = Derivation::carry_out(&mut known, &asked);
        derivation.steps.extend(demanding(&scene.unknowns, &broken_laws(&known)));
        Some(InLetters { rules: derivation.steps, scene, known, asked, found: found.to_vec() })
    }

    /// Does any of these quantities have its value only once the letters are found?
    pub fn are_needed(&self, asked: &[Quantity]) -> bool {
        let mut known = self.known.clone();
        let (_, missing) = Derivation::carry_out(&mut known, asked);
        let depends = |value: &Value| value.has_letter(|letter| self.is_unknown(*letter));
        let open = |quantity: &Quantity| match known.0.get(quantity) {
            Some(Datum::Number(value)) => depends(value),
            Some(Datum::Direction { y, x }) => depends(y) || depends(x),
            Some(Datum::Equation(_)) | None => true,
        };
        !self.found.is_empty() && (!missing.is_empty() || asked.iter().any(open))
    }

    fn is_unknown(&self, letter: Letter) -> bool {
        self.found.iter().any(|(unknown, _)| *unknown == letter)
    }

    /// How it is shown.
    pub fn show(&self) -> Show<'_> {
        Show::new(&self.scene, &self.known, &self.asked)
    }

    /// The lines of the steps once letters are found: a step that was taken in terms of them has its results alone, with
    /// the values put in.
    pub fn put_into(&self, steps: &mut [Step], show: &Show, asked: &[Quantity]) {
        if self.found.is_empty() {
            return;
        }
        if let [Quantity::Deflection(sphere)] = asked
            && let Some(line) = self.deflection(Quantity::TanDeflection(*sphere), Quantity::Deflection(*sphere), show)
        {
            // The tangent says all.
            steps.iter_mut().for_each(|step| step.lines.clear());
            steps.iter_mut().rev().take(1).for_each(|step| step.lines = vec![line.clone()]);
            return;
        }
        let mut equations = Vec::new();
        let mut first = None;
        for (place, step) in steps.iter_mut().enumerate() {
            if !self.rules.iter().any(|rule| **rule == step.rule) {
                continue;
            }
            let Some(results) = self.results(&step.rule, show) else { continue };
            step.lines.clear();
            if !results.is_empty() {
                first.get_or_insert(place);
                equations.extend(results);
            }
        }
        if let Some(place) = first {
            steps[place].lines = vec![self.line(equations)];
        }
    }

    /// What a rule gives, in letters and with their values. `None` if it has no symbol, and its own lines must stand.
    fn results(&self, rule: &Rule, show: &Show) -> Option<Vec<Expr>> {
        let depends = |quantity: &Quantity| {
            let number = self.known.number(*quantity);
            number.is_some_and(|value| value.has_letter(|letter| self.is_unknown(*letter)))
        };
        if rule.gives.iter().all(|quantity| quantity.is_equation()) {
            return Some(Vec::new());
        }
        if rule.impact() > 0 || rule.gives.iter().any(|quantity| self.known.number(*quantity).is_none()) {
            return None;
        }
        let letters = self.show();
        if let [Quantity::Velocity(sphere, moment, Axis::X), Quantity::Velocity(_, _, Axis::Y)] = rule.gives[..] {
            let name = Expr::name(show.vector_letter(sphere, moment));
            return Some(Show::chain(name, [letters.vector(sphere, moment), show.vector(sphere, moment)]));
        }
        let mut equations = Vec::new();
        for quantity in rule.gives.iter().filter(|quantity| depends(quantity)) {
            let Quantity::Velocity(_, Moment::After, Axis::N) = quantity else { return None };
            let worked = |show: &Show| {
                let away = show.setting().works_away_from_b();
                written(&if away { -show.exact(*quantity) } else { show.worked(*quantity) })
            };
            equations.extend(Show::chain(show.symbol(*quantity), [worked(&letters), worked(show)]));
        }
        Some(equations)
    }

    /// The angle by the formula for its tangent, where that has the sign of the angle.
    fn deflection(&self, tangent: Quantity, angle: Quantity, show: &Show) -> Option<Line> {
        let formula = self.known.number(tangent)?;
        let there =
            self.found.iter().try_fold(formula.clone(), |value, (letter, root)| value.substitute(*letter, root))?;
        let angle = show.angle(angle)?;
        if !(angle.y() - &(&there * angle.x())).is_zero() {
            return None;
        }
        let left = Expr::name("delta");
        let tangent = Expr::call(crate::expr::Function::Tan, left.clone());
        let mut equations = Show::chain(tangent, [written(&formula), written(&there)]);
        equations.push(Expr::equation(left.clone(), Show::angle_expr(&angle)));
        equations.extend(Show::approximate_angle(&left, &angle));
        Some(self.line(equations))
    }

    fn line(&self, equations: Vec<Expr>) -> Line {
        let value = |(letter, root): &(Letter, Value)| {
            let name = Expr::name(letter.name().replace("A.mass", "m_A").replace("B.mass", "m_B"));
            match (letter.range(), Angle::of(root, &Value::ONE)) {
                (Range::Acute, Some(angle)) if angle.whole_degrees().is_some() => {
                    Expr::equation(name, written_angle(&angle))
                }
                (Range::Acute, _) => Expr::equation(Expr::call(crate::expr::Function::Tan, name), written(root)),
                _ => Expr::equation(name, written(root)),
            }
        };
        let values: Vec<Expr> = self.found.iter().map(value).collect();
        let names = ["p", "q", "r", "s"];
        let marks: Vec<String> = names.iter().take(values.len()).map(|name| format!("{{{name}}}")).collect();
        let formulas: Vec<(&str, Expr)> = names.into_iter().zip(values).collect();
        Line::with(&format!("With {},", marks.join(" and ")), &formulas, equations).with_masses_in_symbols()
    }
}
