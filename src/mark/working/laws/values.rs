//! Marks for a value that a line states.

use crate::answer::{Accept, Kind};
use crate::bank::Code;
use crate::expr::{Expr, Function};
use crate::mark::judging::{Judgement, Model, Note, Verdict, is_of_a_part, judge, may_be_named, named_spheres};
use crate::mark::key::KeyedMark;
use crate::mark::reading::{Form, Label, Reading, Said, Statement, Vocabulary};
use crate::mark::working::denied::is_bare;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Value, Working, is_of_other};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{Spread, any_within, comes_to, constant, is_composite, is_vector, sizes};
use crate::mark::working::prepared::Prepared;
use crate::mark::working::theirs::letters_of_axes;
use crate::mechanics::{Axis, Datum, Moment, Quantity, Setting, Sphere};

impl Working<'_> {
    /// A mark for a value, or for two: what is not right of them, or else the line by which all is there.
    pub(in crate::mark::working) fn own_values(&self, code: Code, mark: &KeyedMark) -> Option<Evidence> {
        let each = mark.earned_for.quantities().iter().enumerate();
        let found = each.map(|(place, quantity)| self.value_of(*quantity, place, code, mark));
        let found = found.collect::<Option<Vec<Evidence>>>()?;
        found.into_iter().max_by_key(|evidence| (!evidence.given, evidence.line))
    }

    /// A line states a value, the first or second of those that the mark is for, with the figures that are asked for.
    fn value_of(&self, quantity: Quantity, place_in_mark: usize, code: Code, mark: &KeyedMark) -> Option<Evidence> {
        if let Some(Expr::Vector(x, y)) = mark.equation.as_ref().map(right_side) {
            return self.vector_of(quantity, [x, y], code);
        }
        let along = along_for(quantity, self.prepared);
        let letter = self.convention.as_ref().and_then(|convention| {
            let place = Sphere::BOTH
                .into_iter()
                .position(|sphere| along == Quantity::Velocity(sphere, Moment::After, Axis::N))?;
            Some((convention.letters[place].clone(), convention.signs[place]))
        });
        // What moves along the line of centres has a letter for its speed.
        let own_letter = letter.as_ref().map(|(letter, _)| letter.as_str()).or_else(|| self.letter_along(along));
        let size = match sizes(&self.prepared.known, along).as_deref() {
            Some([size]) => Some(*size),
            _ => None,
        };
        let is_exact = self.must_be_exact(quantity);
        let mut short: Option<(usize, Judgement)> = None;
        let is_reversed = letter.as_ref().is_some_and(|(_, sign)| *sign < 0.0);
        let is_found_otherwise = self.found_otherwise().contains(&quantity);
        for (place, studied) in self.lines.iter().enumerate() {
            let Some(reading) = &studied.reading else { continue };
            for statement in &reading.statements {
                let named = statement.label.as_ref().and_then(|label| label.expr.as_ref());
                let is_named = match (&letter, named) {
                    (Some((letter, _)), Some(Expr::Name(name))) => name.text == *letter,
                    (Some(_), _) => false,
                    (None, _) => statement.label.is_some() || statement.said.len() > 1,
                };
                let of_a_part = |label: &Label| {
                    is_of_a_part(&label.typed, quantity)
                        || !may_be_named(&label.typed, quantity)
                        || self.is_of_unknown(label)
                        || self.is_loss_of_one(&label.typed, quantity)
                };
                let is_of_other =
                    matches!(named, Some(Expr::Name(name)) if self.is_velocity_of_other(&name.text, quantity));
                let is_own = matches!(named, Some(Expr::Name(name)) if Some(name.text.as_str()) == own_letter);
                let is_named = is_named && !is_of_other && !statement.label.as_ref().is_some_and(of_a_part);
                if !is_named || is_found_otherwise && letter.is_none() && !is_own && is_bare(statement) {
                    continue;
                }
                if let (Some(size), Some(said)) = (size, statement.said.last())
                    && self.is_plainly_other(said, size)
                {
                    continue;
                }
                // A rebound from a wall may be counted either way.
                let is_rebound = self.prepared.setting == Setting::Wall && matches!(along, Quantity::Velocity(..));
                let ways: &[bool] = if is_rebound { &[false, true] } else { std::slice::from_ref(&is_reversed) };
                for is_reversed in ways.iter().copied() {
                    let model =
                        mark.stated(place_in_mark, is_reversed, || self.model_of(along, is_reversed, is_exact))?;
                    let verdict = |statement: Statement| {
                        let (statements, printed) = (vec![statement], String::new());
                        let reading = Reading { statements, printed, decided: Vec::new() };
                        judge(model, &Ok(vec![reading]))
                    };
                    let mut end = statement.clone();
                    end.said.drain(..end.said.len().saturating_sub(1));
                    // A right formula that is worked out wrongly is no right value. Most lines end in another value.
                    let last = verdict(end);
                    let all = if last.verdict == Verdict::Wrong { last } else { verdict(statement.clone()) };
                    match all.verdict {
                        Verdict::Correct => return Some(Evidence::given(place, quantity.in_plain_words())),
                        _ if is_short(&all, is_own) => short = short.or(Some((place, all))),
                        _ => {}
                    }
                }
            }
        }
        if let Some((place, Judgement { note, feedback, .. })) = short {
            return Some(Evidence {
                given: false,
                note,
                feedback,
                ..Evidence::given(place, quantity.in_plain_words())
            });
        }
        if code == Code::A1FollowThrough && !self.is_trivial(quantity) {
            let line = self.line_that_is(&self.followed, quantity)?;
            return Some(Evidence::followed(line, quantity.in_plain_words()));
        }
        if let Some(place) = letter.as_ref().and_then(|(letter, sign)| self.undivided(along, letter, *sign)) {
            return Some(Evidence::given(place, quantity.in_plain_words()));
        }
        if along == Quantity::Velocity(Sphere::A, Moment::After, Axis::N) && self.prepared.setting == Setting::Wall {
            let place = self.said_to_rebound(along, Code::M1);
            return place.map(|place| Evidence::given(place, quantity.in_plain_words()));
        }
        let letter = own_letter?;
        let place = self.wrongly_stated(along, letter)?;
        let feedback = format!("{letter} is not right");
        Some(Evidence { given: false, feedback, ..Evidence::given(place, quantity.in_plain_words()) })
    }

    /// Is a letter that of the other sphere, by the equations, where the speed of one is looked for?
    fn is_velocity_of_other(&self, letter: &str, speed: Quantity) -> bool {
        let Quantity::Speed(sphere, Moment::After) = speed else { return false };
        self.convention_by_laws().is_some_and(|convention| is_of_other(&convention.letters, letter, sphere))
    }

    /// The student's letter for the velocity of a sphere whose speed it is too, for it moves along the line of centres.
    fn letter_along(&self, speed: Quantity) -> Option<&str> {
        let Quantity::Speed(sphere, Moment::After) = speed else { return None };
        let across = sizes(&self.prepared.known, Quantity::Velocity(sphere, Moment::After, Axis::T))?;
        let place = Sphere::BOTH.into_iter().position(|one| one == sphere)?;
        let letters = &self.convention.as_ref()?.letters;
        across.iter().all(|size| *size == 0.0).then(|| letters[place].as_str())
    }

    /// The line of `9x = 5v - 4ev`: in letters a component that is left alone is known, divided out or not.
    fn undivided(&self, along: Quantity, letter: &str, sign: f64) -> Option<usize> {
        let right = sizes(&self.prepared.known, along).filter(|right| right.windows(2).any(|two| two[0] != two[1]))?;
        let is = |(own, right): (&f64, &f64)| (sign * own - right).abs() <= 1e-6 * right.abs();
        (0..self.lines.len()).filter(|place| self.lines[*place].matched.is_empty()).find(|place| {
            let alone = self.left_alone(*place);
            let mut own = alone.iter().filter(|(name, _)| name == letter);
            own.any(|(_, values)| values.iter().zip(&right).all(is))
        })
    }

    /// The last line that states a value by the letter of a component after the impact, where none is right.
    fn wrongly_stated(&self, quantity: Quantity, letter: &str) -> Option<usize> {
        let right = sizes(&self.prepared.known, quantity)?;
        let is_right = |values: &[Value]| values.iter().zip(&right).all(|(value, right)| comes_to(*value, *right));
        let states = |studied: &Studied| {
            self.members(studied).any(|(member, values)| {
                let is_open = member.expr.names().iter().any(|name| self.is_unknown(&name.text));
                member.letter.as_deref() == Some(letter) && !is_open && !is_right(values)
            })
        };
        self.lines.iter().rposition(states)
    }

    /// Is it an answer of this part for which the sheet wants the exact value?
    fn must_be_exact(&self, quantity: Quantity) -> bool {
        let mut blanks = self.part.blanks.iter();
        blanks.any(|blank| blank.model.accept == Accept::Exact && blank.find.quantities().contains(&quantity))
    }

    /// Is it a formula with a letter of which nothing is known: `w²`, `2v`? Its value is not that of the letter.
    fn is_of_unknown(&self, label: &Label) -> bool {
        let is_formula = |expr: &&Expr| matches!(expr, Expr::Power(..) | Expr::Product(_) | Expr::Quotient(..));
        label.expr.as_ref().filter(is_formula).is_some_and(|expr| self.values_of(expr).is_none())
    }

    /// Is nothing left to find, where the student's own values leave nought?
    pub(super) fn is_trivial(&self, quantity: Quantity) -> bool {
        let is_nought = |known: &[_]| sizes(known, quantity).is_some_and(|sizes| sizes.iter().all(|size| *size == 0.0));
        is_nought(&self.followed) && !is_nought(&self.prepared.known)
    }

    /// Is it a plain number of quite another size? Most lines are for something else, and that spares judging them.
    fn is_plainly_other(&self, said: &Said, size: f64) -> bool {
        let (Form::Value(expr), None) = (&said.form, &said.unit) else { return false };
        let is_far = |number: f64| (number.abs() - size.abs()).abs() > 0.5 * number.abs().max(size.abs());
        match expr {
            Expr::Number(number) => is_far(number.to_f64()),
            Expr::Decimal(text) => text.parse().is_ok_and(is_far),
            expr if is_arithmetic(expr) => constant(expr, &self.context(0)).is_some_and(|number| {
                let is_narrow = number.high - number.low < 0.1 * number.middle().abs();
                is_narrow && is_far(number.low) && is_far(number.high)
            }),
            _ => false,
        }
    }

    /// May a member be the energy that both spheres lose together? Arithmetic that comes to it has something of either
    /// sphere, or is the difference of the energies; else it must be called a loss.
    pub(super) fn may_be_loss(&self, member: &Member, quantity: Quantity) -> bool {
        let known = &self.prepared.known;
        let masses = Sphere::BOTH.map(|sphere| sizes(known, Quantity::Mass(sphere)));
        let ([Some(a), Some(b)], Quantity::EnergyLost, true) = (&masses, quantity, self.question.letters.is_empty())
        else {
            return true;
        };
        let has = |mass: &[f64]| {
            let halved: Vec<f64> = mass.iter().map(|mass| mass / 2.0).collect();
            let either = [mass.to_vec(), halved];
            any_within(&member.expr, &|inner| !is_composite(inner) && self.is_one_of(inner, &either))
        };
        let is_total = |expr: &Expr, moment| {
            let total = sizes(known, Quantity::TotalEnergy(moment));
            total.is_some_and(|total| self.is_one_of(expr, &[total]))
        };
        let is_difference = || match &member.expr {
            Expr::Sum(terms) => match terms.as_slice() {
                [before, Expr::Negative(after)] => is_total(before, Moment::Before) && is_total(after, Moment::After),
                _ => false,
            },
            _ => false,
        };
        member.label.as_deref().is_some_and(names_loss)
            || is_difference()
            || self.is_of_energies(&member.expr)
            || self.is_of_both_losses(&member.expr)
            || (has(a) && has(b))
    }

    /// `98 + 2 - 60.5 - 32`: the energies of both spheres before and after, each worked out.
    fn is_of_energies(&self, expr: &Expr) -> bool {
        let known = |quantity| sizes(&self.prepared.known, quantity);
        let energy = |(sphere, moment)| -> Option<Vec<f64>> {
            let each = known(Quantity::Mass(sphere))?.into_iter().zip(known(Quantity::Speed(sphere, moment))?);
            Some(each.map(|(mass, speed)| 0.5 * mass * speed * speed).collect())
        };
        let moments = [Moment::Before, Moment::After];
        let all = Sphere::BOTH.into_iter().flat_map(|sphere| moments.map(|moment| (sphere, moment)));
        let Some(energies) = all.map(energy).collect::<Option<Vec<_>>>() else { return false };
        let Expr::Sum(terms) = expr else { return false };
        let has = |energy: &Vec<f64>| terms.iter().any(|term| self.is_one_of(term, std::slice::from_ref(energy)));
        terms.len() == energies.len() && energies.iter().all(has)
    }

    /// Is it said to be lost by one of two spheres, where what both lose together is looked for: `loss in A`?
    pub(super) fn is_loss_of_one(&self, label: &str, quantity: Quantity) -> bool {
        let has_two = matches!(self.prepared.setting, Setting::Oblique | Setting::Direct);
        let is_formula = label.contains(['+', '-', '−']);
        let named = named_spheres(label);
        let is_of_one = named.first().is_some_and(|first| named.iter().all(|other| other == first));
        has_two && quantity.of_its_impact() == Quantity::EnergyLost && !is_formula && is_of_one
    }

    /// The line with the vector of a velocity. Where an impact begins with values of the student's own, what follows from them is
    /// not `stated`, which is right.
    fn vector_of(&self, quantity: Quantity, stated: [&Expr; 2], code: Code) -> Option<Evidence> {
        let Quantity::Velocity(sphere, moment, _) = quantity else { return None };
        let at = |axis| sizes(&self.prepared.known, Quantity::Velocity(sphere, moment, axis));
        let (x, y) = at(Axis::X).zip(at(Axis::Y))?;
        let stated = stated.map(|expr| self.prepared.sizes_of(expr));
        let is_own = |own: &[f64], stated: &Option<Vec<f64>>| {
            stated.as_ref().is_some_and(|stated| own.iter().zip(stated).any(|(own, right)| (own - right).abs() > 1e-9))
        };
        let is_condoned = code == Code::A1FollowThrough || !self.prepared.found.is_empty();
        if !is_condoned && (is_own(&x, &stated[0]) || is_own(&y, &stated[1])) {
            return None;
        }
        let is_exact = self.must_be_exact(quantity);
        let is_right = |values: &[Value]| match is_exact {
            true => is_vector(&exactly(values), &x, &y, 1.0),
            false => is_vector(values, &x, &y, 1.0),
        };
        // A right formula that is worked out wrongly is no right value, here either.
        let same_statement =
            |one: &(&Member, &Vec<Value>), other: &(&Member, &Vec<Value>)| one.0.statement == other.0.statement;
        let is_found_otherwise = self.found_otherwise().contains(&quantity);
        let ends_right = |studied: &Studied| {
            // `perp comps 4i and 2i`: what is a component has no other, though the whole may be as long.
            let is_component = self.says_across(&studied.line.typed);
            let of_vectors = |(member, values): &(&Member, &Vec<Value>)| {
                matches!(values[..], [Value::Vector(..), ..]) && (member.label.is_some() || !is_component)
            };
            let vectors: Vec<_> = self.members(studied).filter(of_vectors).collect();
            // `4i and 2i stay`, where the other component was found to be no nought.
            let counts = |chain: &[(&Member, &Vec<Value>)]| !is_found_otherwise || chain.len() > 1;
            vectors
                .chunk_by(same_statement)
                .any(|chain| counts(chain) && chain.last().is_some_and(|(_, values)| is_right(values)))
        };
        let line = self.lines.iter().position(ends_right).or_else(|| self.line_of_components(sphere, moment))?;
        Some(Evidence::given(line, format!("the velocity of {}", sphere.name())))
    }

    /// The line by which both components of a velocity stand there rightly, under the letters that momentum has for them:
    /// `x = 1, y = -2`.
    fn line_of_components(&self, sphere: Sphere, moment: Moment) -> Option<usize> {
        let of = letters_of_axes(&self.lines, self.prepared);
        let line_of = |axis| {
            let quantity = Quantity::Velocity(sphere, moment, axis);
            let (letter, _) = of.iter().find(|(_, own)| *own == quantity)?;
            let right = sizes(&self.prepared.known, quantity)?;
            let is_right = |(member, values): (&Member, &Vec<Value>)| {
                let comes = values.iter().zip(&right).all(|(value, right)| comes_to(*value, *right));
                member.letter.as_ref() == Some(letter) && comes
            };
            self.lines.iter().position(|studied| self.members(studied).any(is_right))
        };
        Some(line_of(Axis::X)?.max(line_of(Axis::Y)?))
    }

    /// The model answer for a quantity, in the student's direction.
    fn model_of(&self, quantity: Quantity, is_reversed: bool, is_exact: bool) -> Option<Model> {
        let mut known = self.part.known.clone();
        crate::mechanics::Derivation::carry_out(&mut known, &[quantity]);
        let (value, kind) = match known.0.get(&quantity)? {
            Datum::Number(value) => {
                let value = if is_reversed { -value } else { value.clone() };
                let kind = if value.is_constant() { Kind::Number } else { Kind::Expression };
                (crate::expr::written(&value), kind)
            }
            Datum::Direction { y, x } => (crate::expr::written_angle(&crate::number::Angle::of(y, x)?), Kind::Angle),
            Datum::Equation(_) => return None,
        };
        let figures = crate::number::Places::SignificantFigures(3);
        let accept = if is_exact { Accept::Exact } else { Accept::RoundsTo(figures) };
        let vocabulary = Vocabulary { letters: self.question.letters.clone(), vectors: false };
        Some(Model::new(value, kind, accept, vocabulary))
    }
}

/// Does a label speak of what is lost?
pub(super) fn names_loss(label: &str) -> bool {
    // As the model solution has it.
    if label == "L" {
        return true;
    }
    let label = label.to_lowercase();
    label.contains(['δ', '∆']) || ["los", "change", "decrease"].iter().any(|word| label.contains(word))
}

/// Is a value right but for its form, or for its figures or its sign? What has no letter may be another value.
fn is_short(judged: &Judgement, has_letter: bool) -> bool {
    const NEARLY: [Note; 5] = [Note::UnderAccurate, Note::Truncated, Note::NearMiss, Note::TooFewFigures, Note::Sign];
    let is = |note: &Note| judged.note == Some(note.tag());
    is(&Note::ExactWanted) || has_letter && NEARLY.iter().any(is)
}

/// The same as if every figure were as it was meant: what is rounded is not exact, and 1.25 is.
fn exactly(values: &[Value]) -> Vec<Value> {
    let middle = |spread: &Spread| Spread::exactly(spread.middle());
    let exact = |value: &Value| match value {
        Value::Number(number) => Value::Number(middle(number)),
        Value::Vector(x, y) => Value::Vector(middle(x), middle(y)),
    };
    values.iter().map(exact).collect()
}

/// Does it come to a number by arithmetic alone, so that it is no angle and has no letter?
fn is_arithmetic(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => true,
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, angle) => match &**angle {
            Expr::Degrees(degrees) => is_arithmetic(degrees),
            _ => false,
        },
        Expr::Call(Function::Sqrt | Function::Abs, _)
        | Expr::Negative(_)
        | Expr::Sum(_)
        | Expr::Product(_)
        | Expr::Quotient(..)
        | Expr::Power(..) => expr.children().into_iter().all(is_arithmetic),
        _ => false,
    }
}

/// The component along the line of centres that a component along i or j is, where the line is parallel to it.
pub(in crate::mark::working) fn along_for(quantity: Quantity, prepared: &Prepared) -> Quantity {
    match quantity {
        Quantity::Velocity(sphere, moment, axis @ (Axis::X | Axis::Y)) => {
            let along =
                sizes(&prepared.known, Quantity::Line(axis)).is_some_and(|line| (line[0].abs() - 1.0).abs() < 1e-12);
            if along { Quantity::Velocity(sphere, moment, Axis::N) } else { quantity }
        }
        other => other,
    }
}

fn right_side(expr: &Expr) -> &Expr {
    match expr {
        Expr::Relation(_, _, right) => right,
        other => other,
    }
}
