//! Parts and answers checked: what is asked, what is found, of which kind, and how it is accepted.

use super::super::document::{Faults, listed};
use super::super::file::{AnswerFile, DomainFile, MarkFile, PartFile, QuestionFile};
use super::super::literal::Words;
use super::super::question::{Answer, Code, Find, Mark, Part, StyleName};
use super::marks::marks;
use super::names::{Also, NamesUsed};
use super::quantities;
use super::shown::is_tangent;
use super::styles::line;
use crate::answer::{Accept, Kind};
use crate::expr::{Angles, Expr, Markup, Name, Piece, Text, read, read_markup};
use crate::mechanics::Quantity;
use crate::number::Places;

/// The letters that are to be found, whether others stay letters, and which are angles.
type Letters<'s> = (&'s [String], bool, &'s dyn Fn(&str) -> bool);

/// Every part of a file.
pub fn parts(file: &QuestionFile, used: &mut NamesUsed, faults: &mut Faults) -> Vec<Part> {
    let scene = file.scene.as_ref().map(|scene| &scene.text);
    let unknowns = scene.map(|scene| scene.unknowns.clone()).unwrap_or_default();
    let lettered = scene.is_some_and(|scene| {
        scene.symbols.keys().any(|symbol| !unknowns.contains(symbol) && is_given_as_a_letter(symbol, file))
    });
    let is_angle =
        |letter: &str| scene.is_some_and(|scene| scene.symbols.get(letter).is_some_and(|kind| kind == "acute"));
    let mut found = Vec::new();
    for (index, part) in file.parts.iter().enumerate() {
        let label = match file.parts.len() {
            1 => String::new(),
            _ => char::from_u32('a' as u32 + index as u32)
                .filter(char::is_ascii_lowercase)
                .map(String::from)
                .unwrap_or_else(|| (index + 1).to_string()),
        };
        let answers = answers(part, file, (&unknowns, lettered, &is_angle), used, faults);
        let ask = part.ask.as_ref().and_then(|ask| read_ask(ask, &answers, used, faults)).unwrap_or_default();
        if part.answers.is_empty() {
            let help = "add `answers = [{ name = \"speed of *A*\", find = \"A.after.speed\" }]`";
            faults.report(part.span.clone(), "a part without answers", "nothing is found here", help);
        }
        if part.marks.is_empty() {
            let help = "add `marks = [{ code = \"B1\", for = \"perpendicular\" }]`";
            faults.report(part.span.clone(), "a part without marks", "nothing is earned here", help);
        }
        let marks = marks(&part.marks, &unknowns, used, faults);
        starred(part, &answers, &marks, faults);
        found.push(Part { label, ask, answers, marks });
    }
    exact_names(file, faults);
    found
}

/// Does a number of the question hold a letter? One that the words alone have, as in `{tan(alpha) = t}`, is in no answer.
fn is_given_as_a_letter(letter: &str, file: &QuestionFile) -> bool {
    let is_name = |sign: char| sign.is_ascii_alphanumeric() || sign == '_';
    let holds = |words: &Words| words.get_ref().split(|sign| !is_name(sign)).any(|name| name == letter);
    let has = |(_, domain): &(Words, DomainFile)| match domain {
        DomainFile::Range(value) => holds(value),
        DomainFile::List(values, _) => values.iter().any(holds),
    };
    let is_declaration = |path: &str| path.starts_with("symbols") || path.starts_with("unknowns");
    let mut scene = file.scene.iter().flat_map(|scene| &scene.places).filter(|(path, _)| !is_declaration(path));
    let mut lets = file.lets.iter().chain(file.styles.iter().flat_map(|style| &style.lets));
    scene.any(|(_, words)| holds(words))
        || lets.any(|(_, words)| holds(words))
        || file.parameters.iter().chain(file.styles.iter().flat_map(|style| &style.parameters)).any(has)
}

/// A result that is printed earns nothing by itself, which its mark says, `A1*`; another answer has no such mark.
fn starred(part: &PartFile, answers: &[Answer], marks: &[Mark], faults: &mut Faults) {
    let place = |mark: &MarkFile| mark.code.as_ref().map_or(mark.span.clone(), |code| code.span());
    let is_shown = answers.iter().any(|answer| answer.kind == Kind::Shown);
    let rows = || part.marks.iter().zip(marks);
    if !is_shown && answers.len() == part.answers.len() {
        for (row, _) in rows().filter(|(_, mark)| mark.code == Code::A1Shown) {
            let help =
                "write `A1`; or give the answer `kind = \"shown\"`, and print its result with `{display: result}`";
            faults.report(place(row), "`A1*` where nothing is to be shown", "it is for a result that is printed", help);
        }
    }
    let last = rows().rev().find(|(_, mark)| mark.code.is_accuracy());
    let are_shown = is_shown && answers.iter().all(|answer| answer.kind == Kind::Shown);
    if let (true, Some((row, mark))) = (are_shown, last)
        && marks.iter().all(|mark| mark.code != Code::A1Shown)
    {
        let message = format!("`{}` for a result that is printed", mark.code.name());
        let label = "whoever copies it would earn this";
        faults.report(place(row), message, label, "write `A1*`, which is for the way to the result");
    }
}

/// The words of a part; `{result}` and `{display: result}` stand for what is to be shown.
fn read_ask(words: &Words, answers: &[Answer], used: &mut NamesUsed, faults: &mut Faults) -> Option<Markup> {
    let paragraphs = read_markup(words.get_ref()).map_err(|fault| faults.expression(words, fault)).ok()?;
    let shown = answers.iter().any(|answer| answer.show.is_some());
    let is_stated = |text: &Text| text.0.iter().any(states);
    if shown && !paragraphs.iter().any(is_stated) {
        faults.report(
            words.span(),
            "the words do not say what is to be shown",
            "expected the result in them",
            "write `Show that {display: result}`",
        );
    }
    for text in &paragraphs {
        for expr in formulas(&text.0) {
            for name in expr.names() {
                if name.text != "result" {
                    if !is_starred(words, name) {
                        used.name(words, name, Also::Nothing, None, faults);
                    }
                } else if !shown {
                    faults.report(
                        faults.place(words, name.span),
                        "`result` in a part that shows nothing",
                        "no answer here has `show`",
                        "add `show = \"tan(beta)\"` to the answer that is to be shown",
                    );
                }
            }
        }
    }
    Some(paragraphs)
}

/// Does a formula state a result, or an equation?
fn states(piece: &Piece) -> bool {
    let is_result = |expr: &Expr| match expr {
        Expr::Name(name) => name.text == "result",
        _ => matches!(expr, Expr::Relation(..)),
    };
    formulas(std::slice::from_ref(piece)).into_iter().any(is_result)
}

fn is_starred(words: &Words, name: &Name) -> bool {
    words.get_ref().get(..name.span.start).is_some_and(|before| before.ends_with('*'))
}

fn formulas(pieces: &[Piece]) -> Vec<&Expr> {
    pieces
        .iter()
        .flat_map(|piece| match piece {
            Piece::Words(_) => Vec::new(),
            Piece::Italic(inner) => formulas(inner),
            Piece::Formula(expr) | Piece::Quantity(expr, _) | Piece::Display(expr) => vec![expr],
        })
        .collect()
}

fn answers(
    part: &PartFile,
    file: &QuestionFile,
    letters: Letters,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Vec<Answer> {
    let mut found: Vec<Answer> = Vec::new();
    let mut names: Vec<&str> = Vec::new();
    for (place, answer) in part.answers.iter().enumerate() {
        let texts = |answer: &AnswerFile| answer.find.iter().map(|words| words.get_ref().clone()).collect::<Vec<_>>();
        let asks_it = |other: &&AnswerFile| !answer.find.is_empty() && texts(other) == texts(answer);
        if let (Some(_), Some(find)) = (part.answers[..place].iter().find(asks_it), answer.find.first()) {
            let message = format!("two answers of this part ask for `{}`", texts(answer).join("`, `"));
            faults.report(find.span(), message, "it was asked for before", "take one of the two answers out");
            continue;
        }
        if let Some(name) = &answer.name {
            if names.contains(&name.get_ref().as_str()) {
                let message = format!("two answers of this part are called `{}`", name.get_ref());
                let label = "a student could not tell them apart";
                faults.report(name.span(), message, label, "give each answer a name of its own");
            }
            names.push(name.get_ref());
        }
        let checked = one_answer(answer, letters, used, faults);
        found.extend(checked.map(|checked| Answer { exact_in: exact_in(answer, file), ..checked }));
    }
    found
}

/// The styles that want the exact value of an answer.
fn exact_in(answer: &AnswerFile, file: &QuestionFile) -> Vec<StyleName> {
    let named = answer.name.as_ref().map(|name| name.get_ref());
    let wanting = file.styles.iter().filter(|style| style.exact.iter().any(|name| Some(name.get_ref()) == named));
    wanting.filter_map(|style| StyleName::ALL.into_iter().find(|known| known.name() == style.name.get_ref())).collect()
}

/// What a style wants exact must be an answer of some part.
fn exact_names(file: &QuestionFile, faults: &mut Faults) {
    let answers = file.parts.iter().flat_map(|part| &part.answers).filter_map(|answer| answer.name.as_ref());
    let names: Vec<&str> = answers.map(|name| name.get_ref().as_str()).collect();
    // That there are no answers at all is a fault of its own, and told as such.
    if names.is_empty() {
        return;
    }
    for style in &file.styles {
        faults.twice("the name", &[], &style.exact);
    }
    for wanted in file.styles.iter().flat_map(|style| &style.exact) {
        let text = wanted.get_ref().as_str();
        if !names.contains(&text) {
            let label = format!("expected {}", listed(&names));
            faults.unknown(wanted.span(), format!("no answer is called `{text}`"), label, text, names.iter().copied());
        }
    }
}

fn one_answer(
    answer: &AnswerFile,
    (unknowns, lettered, is_angle): Letters,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Option<Answer> {
    let name = answer.name.as_ref().and_then(|words| line(words, None, used, faults));
    let find = read_find(answer, unknowns, faults);
    let kind = answer.kind.as_ref().map(|words| read_kind(words, faults));
    let accept = answer.accept.as_ref().map(|words| read_accept(words, faults));
    let phrase = answer.phrase.as_ref().and_then(|words| line(words, None, used, faults)).unwrap_or_default();
    let show = answer.show.as_ref().map(|words| read_show(words, find.as_ref(), used, faults));
    let (name, find) = (name?, find?);
    let kind = match kind {
        Some(kind) => kind?,
        None if show.is_some() => Kind::Shown,
        None => inferred(&find, lettered, is_angle),
    };
    check_kind(answer, &find, kind, faults);
    let accept = match accept {
        Some(accept) => accept?,
        // An angle is a number of degrees, whatever letters there are.
        None if (lettered && kind != Kind::Angle) || kind == Kind::Shown => Accept::Exact,
        None => Accept::RoundsTo(Places::SignificantFigures(3)),
    };
    Some(Answer { name, find, kind, accept, exact_in: Vec::new(), phrase, show: show.flatten() })
}

fn inferred(find: &Find, lettered: bool, is_angle: &dyn Fn(&str) -> bool) -> Kind {
    match find {
        Find::Vector(..) => Kind::Vector,
        Find::Unknown(letter) if is_angle(letter) => Kind::Angle,
        Find::Quantity(quantity) if quantity.is_angle() => Kind::Angle,
        _ if lettered => Kind::Expression,
        _ => Kind::Number,
    }
}

/// Does the kind fit what is found?
fn check_kind(answer: &AnswerFile, find: &Find, kind: Kind, faults: &mut Faults) {
    let span = answer.kind.as_ref().map_or(answer.span.clone(), |words| words.span());
    let two = matches!(find, Find::Vector(..));
    if two != matches!(kind, Kind::Vector | Kind::Line) && !(two && kind == Kind::Shown) {
        let (found, expected) = if two {
            ("two components", "expected kind `vector` or `line`")
        } else {
            ("one quantity", "a vector is found by its two components")
        };
        let message = format!("kind `{}` for {found}", kind.name());
        faults.report(span, message, expected, "write `find = [\"A.after.x\", \"A.after.y\"]` for a vector");
    } else if kind == Kind::Angle && !matches!(find, Find::Quantity(quantity) if quantity.is_angle()) {
        let is_unknown = matches!(find, Find::Unknown(_));
        if !is_unknown {
            let help = "leave `kind` out, and it follows from what is found";
            faults.report(span, "kind `angle` for a quantity that is no angle", "expected a quantity in degrees", help);
        }
    } else if kind == Kind::Shown && answer.show.is_none() {
        let help = match find {
            Find::Quantity(quantity) if !is_tangent(quantity.of_its_impact()) => {
                "add `show = \"v\"`, a letter for what is found, and declare it: `v = \"positive\"` in `[scene.symbols]`"
            }
            _ => "add `show = \"tan(beta)\"`, the left side of the result",
        };
        faults.report(span, "nothing says what is to be shown", "expected `show` beside it", help);
    } else if kind != Kind::Shown
        && let Some(show) = &answer.show
    {
        let message = format!("`show` for an answer of kind `{}`", kind.name());
        faults.report(show.span(), message, "only for kind `shown`", "leave `kind` out");
    }
}

fn read_find(answer: &AnswerFile, unknowns: &[String], faults: &mut Faults) -> Option<Find> {
    let quantity = |words: &Words, faults: &mut Faults| {
        let text = words.get_ref().as_str();
        let found = text.parse::<Quantity>().ok();
        if found.is_none() {
            quantities::unknown(words, unknowns, faults);
        }
        found
    };
    match answer.find.as_slice() {
        [] => None,
        [words] if unknowns.contains(words.get_ref()) && words.get_ref().parse::<Quantity>().is_err() => {
            Some(Find::Unknown(words.get_ref().clone()))
        }
        [words] => quantity(words, faults).map(Find::Quantity),
        [x, y] => {
            let found = (quantity(x, faults)?, quantity(y, faults)?);
            components(found, y, faults);
            Some(Find::Vector(found.0, found.1))
        }
        [_, _, third, ..] => {
            let help = "write `find = [\"A.after.x\", \"A.after.y\"]`";
            faults.report(third.span(), "a third component", "a vector has two, along i and j", help);
            None
        }
    }
}

/// The two must be the components of one vector, first that along i and then that along j.
fn components((x, y): (Quantity, Quantity), place: &Words, faults: &mut Faults) {
    let (x, y) = (x.to_string(), y.to_string());
    let of = x.strip_suffix(['x', 'y', 'n', 't']).filter(|of| of.ends_with(['.', 'p']));
    if of.is_some_and(|of| x.ends_with('x') && y == format!("{of}y")) {
        return;
    }
    let help = match of {
        Some(of) => format!("write `find = [\"{of}x\", \"{of}y\"]`"),
        None => "write `find = [\"A.after.x\", \"A.after.y\"]` for a vector".to_owned(),
    };
    let message = format!("`{x}` and `{y}` are not the two components of a vector");
    faults.report(place.span(), message, "expected that along i, and then that along j of the same", help);
}

fn read_kind(words: &Words, faults: &mut Faults) -> Option<Kind> {
    let text = words.get_ref().as_str();
    let found = text.parse::<Kind>().ok().filter(|kind| Kind::IN_BANK.contains(kind));
    if found.is_none() {
        let names = Kind::IN_BANK.map(Kind::name);
        let label = format!("expected {}", listed(&names));
        faults.unknown(words.span(), format!("unknown kind of answer `{text}`"), label, text, names);
    }
    found
}

fn read_accept(words: &Words, faults: &mut Faults) -> Option<Accept> {
    let text = words.get_ref().as_str();
    let found = text.parse::<Accept>().ok();
    if found.is_none() {
        let label = "expected `exact`, `awrt 3sf`, `3sf`, `2dp` or `nearest 1`".to_owned();
        let usual = ["exact", "awrt 3sf", "3sf", "2dp", "nearest 1"];
        let squeezed: String = text.to_lowercase().chars().filter(|c| !matches!(c, '.' | ' ')).collect();
        let meant = usual.into_iter().find(|rule| rule.replace(' ', "") == squeezed);
        let candidates: Vec<&str> = meant.map_or(usual.to_vec(), |rule| vec![rule]);
        let name = meant.unwrap_or(text);
        faults.unknown(words.span(), format!("unknown rule of acceptance `{text}`"), label, name, candidates);
    }
    found
}

/// The left side of what is shown: for a letter that is found it must hold that letter.
fn read_show(words: &Words, find: Option<&Find>, used: &mut NamesUsed, faults: &mut Faults) -> Option<Expr> {
    let expr = read(words.get_ref(), Angles::Degrees).map_err(|fault| faults.expression(words, fault)).ok()?;
    if let Expr::Relation(..) = expr {
        let left = words.get_ref().split('=').next().unwrap_or_default().trim().to_owned();
        let message = "`show` holds a whole equation";
        let label = "expected its left side, the right one is computed";
        faults.report(words.span(), message, label, format!("write `show = \"{left}\"`"));
        return None;
    }
    if let Some(Find::Unknown(unknown)) = find {
        used.expression(words, &expr, Also::Nothing, None, faults);
        if !expr.names().iter().any(|name| name.text == *unknown) {
            faults.report(
                words.span(),
                format!("`{}` is shown, but `{unknown}` is found", words.get_ref()),
                format!("expected a formula in `{unknown}`"),
                format!("write `{unknown}` in `show`, or find what is shown"),
            );
        }
    }
    Some(expr)
}

#[cfg(test)]
mod tests {
    use crate::answer::{Accept, Kind};
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::number::Places;

    #[test]
    fn letters_that_the_words_alone_have_leave_an_answer_a_number() {
        let three = Accept::RoundsTo(Places::SignificantFigures(3));
        let beta = "[scene.symbols]\nbeta = \"acute\"\n\n[reference]";
        for (id, kind, accept) in [
            ("direct/restitution-from-one-speed", Kind::Number, three),
            ("direct/velocities-in-letters", Kind::Expression, Accept::Exact),
        ] {
            let (_, text) = shipped().find(|(own, _)| *own == id).unwrap();
            let text = text.replace(", accept = \"exact\"", "").replace(", accept = \"awrt 3sf\"", "");
            let text = if text.contains("[scene.symbols]") { text } else { text.replace("[reference]", beta) };
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let answer = &question.parts[0].answers[0];
            assert_eq!((answer.kind, &answer.accept), (kind, &accept), "{id}");
        }
    }
}
