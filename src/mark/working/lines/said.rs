//! What the words of a line say of a component: that it is along the line of centres, or across it.

use super::line::Member;
use crate::answer::Kind;
use crate::bank::Find;
use crate::expr::Expr;
use crate::mark::judging::{Model, named_spheres, words_fit};
use crate::mark::reading::{Form, Reading, Said, Statement};
use crate::mark::working::examine::{Studied, Working};
use crate::mark::working::numbers::sizes;
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

impl Working<'_> {
    /// Does a line only list the components across the line of centres, of A and then of B, and say that they are:
    /// `j components stay -3 and -2`?
    pub(in crate::mark::working) fn lists_components(&self, studied: &Studied, across: &[(Sphere, Vec<f64>)]) -> bool {
        let typed = &studied.line.typed;
        let Some(listed) = numbers_listed(typed).filter(|listed| listed.len() == across.len()) else { return false };
        // Along i or j a component has its sign.
        let is = |own: f64, right: f64| match self.prepared.in_components {
            true => (own - right).abs() < 1e-9,
            false => (own.abs() - right.abs()).abs() < 1e-9,
        };
        let is_one = |(own, (_, right)): (&f64, &(Sphere, Vec<f64>))| matches!(right[..], [right] if is(*own, right));
        let is_turned = typed.find('B').zip(typed.find('A')).is_some_and(|(of_b, of_a)| of_b < of_a);
        let is_across = says_across(typed) || self.begins_with_axis_across(typed);
        is_across && !typed.contains("along") && !is_turned && listed.iter().zip(across).all(is_one)
    }

    /// `j: 2 and 1`, where the line of centres is parallel to i.
    fn begins_with_axis_across(&self, typed: &str) -> bool {
        let along = |axis| sizes(&self.prepared.known, Quantity::Line(axis)).map(|line| line[0].abs());
        let across = match [Axis::X, Axis::Y].map(along) {
            [Some(x), Some(y)] if y < 1e-9 && x > 0.0 => "j",
            [Some(x), Some(y)] if x < 1e-9 && y > 0.0 => "i",
            _ => return false,
        };
        typed.split(|sign: char| !sign.is_alphanumeric()).find(|word| !word.is_empty()) == Some(across)
    }

    /// Is it said of what stands here that it stays, and not of a list with something else in it?
    pub(in crate::mark::working) fn says_unchanged(&self, typed: &str) -> bool {
        says_unchanged(typed) && numbers_listed(typed).is_none_or(|listed| listed.len() <= self.across().len())
    }
}

/// The numbers of a line that is a list of them in words, with nothing to work out.
fn numbers_listed(typed: &str) -> Option<Vec<f64>> {
    let typed = typed.replace('−', "-");
    let is_plain = |sign: char| sign.is_alphanumeric() || " .,;:&-'()".contains(sign);
    if !typed.chars().all(is_plain) {
        return None;
    }
    let words = typed
        .split([' ', ',', ';', ':', '&', '(', ')'])
        .filter(|word| word.contains(|sign: char| sign.is_ascii_digit()));
    words.map(|word| word.trim_end_matches('.').parse().ok()).collect()
}

/// What a line calls what a blank asks for: an answer, where the blank was left open.
pub(crate) struct Stated {
    /// The line as it was typed.
    pub(crate) typed: String,
    /// What it says of that alone.
    pub(crate) reading: Reading,
    /// Does the right value stand nowhere in the lines?
    pub(crate) is_never_right: bool,
}

impl Working<'_> {
    /// The last line that states a value for a blank by its name: `speed of B = 8`, `I = 51`. A letter for a velocity or an
    /// angle names nothing: it may be of a component, or of another line.
    pub(in crate::mark::working) fn stated(&self, place: usize) -> Option<Stated> {
        let blank = &self.part.blanks[place];
        let is_named = |statement: &&Statement| {
            let Some(label) = &statement.label else { return false };
            let is_name = match (&blank.find, &label.expr) {
                // What is lost may be the energy.
                (Find::Quantity(quantity), _) if quantity.of_its_impact() == Quantity::FractionLost => {
                    has_word(&label.typed, &["fraction", "proportion"])
                }
                (Find::Quantity(quantity), Some(_)) => names_itself(quantity.of_its_impact()),
                (Find::Vector(x, _), None) => names_vector(&label.typed, *x),
                (Find::Vector(..), Some(_)) => false,
                (Find::Quantity(_), None) | (Find::Unknown(_), _) => true,
            };
            is_name && self.part.calls(place, statement) && words_fit(&blank.model, &label.typed)
        };
        self.lines.iter().enumerate().rev().find_map(|(place, studied)| {
            let statements = &studied.reading.as_ref()?.statements;
            let at = statements.iter().rposition(|statement| is_named(&statement))?;
            let mut statement = Some(&statements[at]).filter(|statement| is_a_value(statement, &blank.model))?.clone();
            if at + 1 == statements.len() {
                statement.said.extend(self.goes_on_with(place));
            }
            // `m = 2 or -1`: a second value without a name is of the same letter.
            let is_letter = matches!(blank.find, Find::Unknown(_));
            let rivals = statements[at + 1..].iter().take_while(|rival| is_letter && rival.label.is_none()).cloned();
            let statements = std::iter::once(statement).chain(rivals).collect();
            let reading = Reading { statements, printed: String::new(), decided: Vec::new() };
            let (typed, is_never_right) = (studied.line.typed.clone(), !self.has_right_value(&blank.find));
            Some(Stated { typed, reading, is_never_right })
        })
    }
}

impl Working<'_> {
    /// What the lines after this one go on with: `= 6.5` below `loss = 100 - 92.5`.
    fn goes_on_with(&self, place: usize) -> Vec<Said> {
        let later = self.lines[place + 1..].iter().take_while(|studied| studied.line.goes_on());
        let only = |studied: &Studied| match studied.reading.as_ref()?.statements.as_slice() {
            [Statement { label: None, said }] => Some(said.clone()),
            _ => None,
        };
        later.map(only).take_while(Option::is_some).flatten().flatten().collect()
    }
}

/// Is a letter for it a name that the subject has for nothing else?
fn names_itself(quantity: Quantity) -> bool {
    use Quantity::*;
    matches!(
        quantity,
        Impulse(..) | ImpulseMagnitude | EnergyLost | SphereEnergyLost(_) | SphereEnergyGained(_) | Restitution
    )
}

/// `velocity of B`, `impulse`, `line of centres`: do words name this vector, and none of another sphere or moment?
fn names_vector(typed: &str, component: Quantity) -> bool {
    let is_other = |sphere: &Sphere| component.sphere().is_some_and(|own| own != *sphere);
    let name = match component.of_its_impact() {
        Quantity::Velocity(_, Moment::After, _) => "velocity",
        Quantity::Impulse(..) => "impulse",
        Quantity::Line(_) => "centres",
        _ => return false,
    };
    has_word(typed, &[name]) && !has_word(typed, &["before", "initial"]) && !named_spheres(typed).iter().any(is_other)
}

fn has_word(typed: &str, wanted: &[&str]) -> bool {
    typed.split(|sign: char| !sign.is_alphanumeric()).any(|word| wanted.contains(&word.to_lowercase().as_str()))
}

/// Does it come to a value, in the letters of the question alone?
fn is_a_value(statement: &Statement, model: &Model) -> bool {
    let is_of_question = |name: &str| model.vocabulary.letters.iter().any(|letter| letter.name() == name);
    let is_known = |expr: &Expr| expr.names().iter().all(|name| is_of_question(&name.text));
    let is_vector = matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Line);
    match statement.said.last().map(|said| &said.form) {
        Some(Form::Value(expr)) => !is_vector && is_known(expr),
        Some(Form::Vector(x, y, _)) => is_vector && is_known(x) && is_known(y),
        _ => false,
    }
}

/// What stands between two things that are said.
const BETWEEN: [&str; 3] = [",", ";", " and "];

/// The clauses of a line.
pub(in crate::mark::working) fn clauses(typed: &str) -> Vec<&str> {
    let mut all = vec![typed];
    for sign in BETWEEN {
        all = all.into_iter().flat_map(|clause| clause.split(sign)).collect();
    }
    all.retain(|clause| !clause.trim().is_empty());
    all
}

/// The clauses of a line in which the words for the two components stand before each, with no sign between them.
pub(in crate::mark::working) fn clauses_by_words(typed: &str) -> Vec<&str> {
    const WORDS: [&str; 5] = ["parallel", "para ", "par ", "perp", "⊥"];
    let lower = typed.to_ascii_lowercase();
    let mut starts: Vec<usize> = WORDS.iter().flat_map(|word| lower.match_indices(word).map(|(at, _)| at)).collect();
    starts.sort_unstable();
    // The first must begin the line: in `8 parallel, 6 perp` the words stand behind.
    if starts.first() != Some(&0) {
        return vec![typed];
    }
    let ends = starts.iter().skip(1).copied().chain([typed.len()]);
    starts.iter().zip(ends).map(|(start, end)| &typed[*start..end]).collect()
}

/// Is it said of what stands here that it is along the line of centres, and of nothing that it is across?
pub(in crate::mark::working) fn says_along(typed: &str) -> bool {
    let typed = typed.to_lowercase();
    let is_of_centres = |rest: &str| {
        let rest = rest.trim_start().trim_start_matches("the ").trim_start();
        !rest.starts_with(char::is_alphabetic) || rest.starts_with('l')
    };
    let is_along = typed.split("along").skip(1).any(is_of_centres);
    !says_across(&typed) && (is_along || names_line(&typed))
}

/// Is it said of what stands here that it is the component with which a wall is hit?
pub(in crate::mark::working) fn says_into_wall(typed: &str) -> bool {
    const INTO: [&str; 6] = ["perp", "⊥", "towards", "into", "normal", "against"];
    let typed = typed.to_lowercase();
    INTO.iter().any(|word| typed.contains(word)) && !typed.contains("para") && !typed.contains("along")
}

/// Is it said of what stands here that it is across the line of centres, or that it stays?
pub(in crate::mark::working) fn says_across(typed: &str) -> bool {
    const WORDS: [&str; 4] = ["perp", "across", "tan", "⊥"];
    let lower = typed.to_lowercase();
    WORDS.iter().any(|word| lower.contains(word)) || says_unchanged(typed)
}

/// Is it said of what stands here that it stays as it is?
fn says_unchanged(typed: &str) -> bool {
    const WORDS: [&str; 7] = ["unchanged", "no change", "not change", "stay", "remain", "unaffected", "constant"];
    let typed = typed.to_lowercase();
    WORDS.iter().any(|word| typed.contains(word))
}

/// Is a value said to be something else than a component of this sphere?
pub(in crate::mark::working) fn is_called_otherwise(member: &Member, sphere: Sphere) -> bool {
    const OTHERS: [&str; 9] = ["time", "mass", "distance", "momentum", "impulse", "force", "energy", "ke", "radius"];
    let label = member.label.as_deref().unwrap_or_default();
    let words: Vec<&str> = label.split(|sign: char| !sign.is_alphanumeric()).collect();
    // `b` is a letter, `B` a sphere, and `vB` its velocity.
    let names = |sphere: Sphere| {
        let is_name = |word: &&str| {
            let before = word.strip_suffix(sphere.name());
            before.is_some_and(|before| before.is_empty() || (before.len() == 1 && "uvwUVW".contains(before)))
        };
        words.iter().any(is_name)
    };
    words.iter().any(|word| OTHERS.contains(&word.to_lowercase().as_str())) || (names(sphere.other()) && !names(sphere))
}

/// `line of centres`, `LOC`, `l.o.c.`
fn names_line(typed: &str) -> bool {
    let mut words = typed.split(|sign: char| !sign.is_alphanumeric());
    words.any(|word| word == "loc") || typed.contains("l.o.c") || typed.contains("line of cent")
}
