//! A question file as it stands on the page: every string with its place, nothing understood yet.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::document::{self, Faults, Keys};
use super::literal::Words;
use super::scene_file::SceneFile;

/// What a person wrote in a question file. What is missing has been reported.
#[derive(Clone, Debug, Default)]
pub struct QuestionFile {
    /// The heading of the question in lists.
    pub title: Option<Words>,
    /// The exercise whose skills it practises.
    pub mirrors: Option<Words>,
    /// The topic under which it is listed.
    pub topic: Option<Words>,
    /// The words before the first part.
    pub stem: Option<Words>,
    /// Requirements of every style.
    pub require: Vec<Words>,
    /// Parameters of every style.
    pub parameters: Vec<(Words, DomainFile)>,
    /// Names derived from parameters, in every style.
    pub lets: Vec<(Words, Words)>,
    /// The styles offered.
    pub styles: Vec<StyleFile>,
    /// The collision.
    pub scene: Option<SceneFile>,
    /// What is asked.
    pub parts: Vec<PartFile>,
    /// The numbers of the exercise that it mirrors.
    pub reference: Vec<(Words, Words)>,
    /// Where `[reference]` stands, if it does.
    pub reference_span: Option<Range<usize>>,
    /// What was wrong with the exercise that it mirrors.
    pub erratum: Option<Words>,
    /// Slips that some of its numbers hide.
    pub hidden: Vec<Words>,
    /// Slips that it cannot tell apart, each line `one = other`.
    pub alike: Vec<Words>,
    /// What the author has worked out.
    pub tests: Vec<TestFile>,
}

/// Answers that the author has worked out, as written.
#[derive(Clone, Debug)]
pub struct TestFile {
    /// Where they stand.
    pub span: Range<usize>,
    /// The style whose numbers they are; without it that of the reference numbers.
    pub style: Option<Words>,
    /// Numbers other than those of the reference.
    pub numbers: Vec<(Words, Words)>,
    /// What is asked, and what it comes to.
    pub answers: Vec<(Words, Words)>,
}

/// The values that a parameter can take, as written.
#[derive(Clone, Debug)]
pub enum DomainFile {
    /// `"2..12 step 2"`, or one expression.
    Range(Words),
    /// `["1/4", "1/3"]`, and where it stands.
    List(Vec<Words>, Range<usize>),
}

/// One style: what it adds to the question or has instead.
#[derive(Clone, Debug)]
pub struct StyleFile {
    /// `friendly`, `exact` or `calculator`.
    pub name: Words,
    /// Another stem.
    pub stem: Option<Words>,
    /// A line after the stem.
    pub note: Option<Words>,
    /// Names of the answers that must be exact.
    pub exact: Vec<Words>,
    /// More requirements.
    pub require: Vec<Words>,
    /// More or other parameters.
    pub parameters: Vec<(Words, DomainFile)>,
    /// More or other derived names.
    pub lets: Vec<(Words, Words)>,
}

/// One part as written.
#[derive(Clone, Debug)]
pub struct PartFile {
    /// Where it stands.
    pub span: Range<usize>,
    /// What is asked.
    pub ask: Option<Words>,
    /// The answers.
    pub answers: Vec<AnswerFile>,
    /// The marks.
    pub marks: Vec<MarkFile>,
}

/// One answer as written.
#[derive(Clone, Debug)]
pub struct AnswerFile {
    /// Where it stands.
    pub span: Range<usize>,
    /// What it is, in words.
    pub name: Option<Words>,
    /// One quantity, or the two components of a vector.
    pub find: Vec<Words>,
    /// The kind, if it is not left to be inferred.
    pub kind: Option<Words>,
    /// The rule by which a student's answer is accepted.
    pub accept: Option<Words>,
    /// Words that complete a direction.
    pub phrase: Option<Words>,
    /// The left side of what is to be shown.
    pub show: Option<Words>,
}

/// One mark as written.
#[derive(Clone, Debug)]
pub struct MarkFile {
    /// Where it stands.
    pub span: Range<usize>,
    /// `M1`, `A1`, …
    pub code: Option<Words>,
    /// The law or quantity that earns it.
    pub earned_for: Option<Words>,
    /// What earns it, in words of the question's own.
    pub text: Option<Words>,
    /// What the marker condones or demands.
    pub note: Option<Words>,
    /// The marks without which it is not given.
    pub depends: Option<Vec<Words>>,
}

/// Reads a question file; whatever is not as it should be is reported, the rest is read.
pub fn read(faults: &mut Faults) -> Option<QuestionFile> {
    let text = faults.source.text.clone();
    let document = document::parse(&text, faults)?;
    let mut keys = Keys::of("a question", document.get_ref(), 0..0);
    let mut file = QuestionFile {
        title: keys.required("title", "title = \"A strikes B at rest\"", faults),
        mirrors: keys.words("mirrors", faults),
        topic: keys.required("topic", "topic = \"B at rest\"", faults),
        stem: keys.required("stem", "stem = '''…'''", faults),
        require: keys.list("require", faults),
        hidden: keys.list("hidden", faults),
        alike: keys.list("alike", faults),
        ..QuestionFile::default()
    };
    keys.are_above_headings("the question", faults);
    file.parameters = keys.get("parameters").map_or_else(Vec::new, |value| parameters(value, faults));
    file.lets = keys.get("let").map_or_else(Vec::new, |value| strings("`let`", value, faults));
    keys.demand("style", "[style.exact]");
    if let Some(value) = keys.get("style") {
        for (name, value) in document::pairs("`style`", value, faults) {
            file.styles.extend(style(name, value, faults));
        }
    }
    keys.demand("scene", "[scene]");
    file.scene = keys.get("scene").and_then(|value| SceneFile::read(value, faults));
    keys.demand("part", "[[part]]");
    file.parts = keys.tables("part", "a part", faults).into_iter().map(|keys| part(keys, faults)).collect();
    keys.demand("reference", &reference_example(&file));
    if let Some(value) = keys.get("reference") {
        file.reference = strings("`reference`", value, faults);
        file.reference_span = Some(value.span());
        if let Some(index) = file.reference.iter().position(|(name, _)| name.get_ref() == "erratum") {
            file.erratum = Some(file.reference.remove(index).1);
        }
    }
    file.tests = keys.tables("test", "a test", faults).into_iter().map(|keys| test(keys, faults)).collect();
    keys.finish(faults);
    (!faults.is_unread).then_some(file)
}

/// The heading of the reference numbers, and which of them there must be; it stands between backticks.
fn reference_example(file: &QuestionFile) -> String {
    let of_style = file.styles.first().into_iter().flat_map(|style| &style.parameters);
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in file.parameters.iter().chain(of_style) {
        if !names.contains(&name.get_ref().as_str()) {
            names.push(name.get_ref());
        }
    }
    match names.as_slice() {
        [] => "[reference]".to_owned(),
        [only] => format!("[reference]` with a value for `{only}"),
        [first @ .., last] => {
            format!("[reference]` with a value for each of {} and `{last}", document::listed(first))
        }
    }
}

fn test(mut keys: Keys, faults: &mut Faults) -> TestFile {
    const EXAMPLE: &str = "answers = { \"A.after.speed\" = \"2.78\" }";
    keys.demand("answers", EXAMPLE);
    let answers = keys.get("answers");
    if let Some(value) = answers.filter(|value| value.get_ref().as_table().is_some_and(|table| table.is_empty())) {
        let help = format!("write what you have worked out: `{EXAMPLE}`, or take the test out");
        faults.report(value.span(), "a test without an answer", "nothing is compared here", help);
    }
    let test = TestFile {
        span: keys.span(),
        style: keys.words("style", faults),
        numbers: keys.get("numbers").map_or_else(Vec::new, |value| strings("`numbers`", value, faults)),
        answers: answers.map_or_else(Vec::new, |value| strings("`answers`", value, faults)),
    };
    keys.finish(faults);
    test
}

fn style(name: Words, value: &Spanned<DeValue>, faults: &mut Faults) -> Option<StyleFile> {
    let mut keys = Keys::within("a style", value, faults)?;
    let style = StyleFile {
        name,
        stem: keys.words("stem", faults),
        note: keys.words("note", faults),
        exact: keys.list("exact", faults),
        require: keys.list("require", faults),
        parameters: keys.get("parameters").map_or_else(Vec::new, |value| parameters(value, faults)),
        lets: keys.get("let").map_or_else(Vec::new, |value| strings("`let`", value, faults)),
    };
    keys.finish(faults);
    Some(style)
}

fn parameters(value: &Spanned<DeValue>, faults: &mut Faults) -> Vec<(Words, DomainFile)> {
    let mut found = Vec::new();
    for (name, value) in document::pairs("`parameters`", value, faults) {
        let what = format!("parameter `{}`", name.get_ref());
        let domain = match value.get_ref() {
            DeValue::Array(items) => {
                let values = document::list(&format!("a value of {what}"), value, faults);
                // A list of which no value can be read has been told of, and is not empty.
                let values = if values.is_empty() && !items.is_empty() { vec![one(value)] } else { values };
                DomainFile::List(values, value.span())
            }
            _ => DomainFile::Range(document::words(&what, value, faults).unwrap_or_else(|| one(value))),
        };
        found.push((name, domain));
    }
    found
}

fn strings(what: &str, value: &Spanned<DeValue>, faults: &mut Faults) -> Vec<(Words, Words)> {
    let mut found = Vec::new();
    for (name, value) in document::pairs(what, value, faults) {
        let text = document::words(&format!("`{}`", name.get_ref()), value, faults);
        found.push((name, text.unwrap_or_else(|| one(value))));
    }
    found
}

/// In place of a value of the wrong type, so that its name is known and what follows is no fault too.
fn one(value: &Spanned<DeValue>) -> Words {
    Spanned::new(value.span(), "1".to_owned())
}

fn part(mut keys: Keys, faults: &mut Faults) -> PartFile {
    let part = PartFile {
        span: keys.span(),
        ask: keys.required("ask", "ask = \"Find the speed of *A* immediately after the collision.\"", faults),
        answers: keys.tables("answers", "an answer", faults).into_iter().map(|keys| answer(keys, faults)).collect(),
        marks: keys.tables("marks", "a mark", faults).into_iter().map(|keys| mark(keys, faults)).collect(),
    };
    keys.finish(faults);
    part
}

fn answer(mut keys: Keys, faults: &mut Faults) -> AnswerFile {
    let name = keys.required("name", "name = \"speed of *A*\"", faults);
    let find = match keys.get("find") {
        Some(value) if matches!(value.get_ref(), DeValue::Array(_)) => document::list("`find`", value, faults),
        Some(value) => document::words("`find`", value, faults).into_iter().collect(),
        None => Vec::new(),
    };
    let answer = AnswerFile {
        span: keys.span(),
        name,
        find,
        kind: keys.words("kind", faults),
        accept: keys.words("accept", faults),
        phrase: keys.words("phrase", faults),
        show: keys.words("show", faults),
    };
    // Nobody asks for the range of a speed.
    let is_range = answer.kind.as_ref().is_some_and(|kind| kind.get_ref() == "range");
    keys.demand("find", if is_range { "find = \"e\"" } else { "find = \"A.after.speed\"" });
    keys.finish(faults);
    answer
}

fn mark(mut keys: Keys, faults: &mut Faults) -> MarkFile {
    let code = keys.required("code", "code = \"M1\"", faults);
    let earned_for = keys.required("for", "for = \"momentum\"", faults);
    let text = keys.words("text", faults);
    let note = keys.words("note", faults);
    let depends = keys.get("depends").map(|value| document::list("`depends`", value, faults));
    let mark = MarkFile { span: keys.span(), code, earned_for, text, note, depends };
    keys.finish(faults);
    mark
}
