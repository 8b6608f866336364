//! `carom compare`: how one answer would be marked, and why.

use clap::Args;
use serde_json::{Value as Json, json};

use super::compare_stream;
use super::failure::Failure;
use super::output::{listed, print, print_json};
use crate::answer::{Accept, Kind};
use crate::diagnostic::{Diagnostic, Source, near};
use crate::expr::Fault;
use crate::mark::judging::{Judgement, Model, ModelOptions, judge};
use crate::mark::reading::read_answer;
use crate::mechanics::Quantity;
use crate::number::{Letter, Range};

const AFTER: &str = "Examples:
  carom compare '4*sqrt(39)/9' '2.78 m/s'
  carom compare '4*i + j' '(4, 1)'
  carom compare 'atan(7)' '81.9°'
  carom compare 'u*sqrt(1 - e^2*sin(a)^2)' 'u√(1-e²sin²a)' --symbols u=positive,e=unit,a=acute

MODEL is plain ASCII with angles in radians, or in degrees with `deg`; ANSWER is what a student
might type. With `--stream`, each line of stdin is a JSON object with `model` and `answer`,
perhaps `kind`, `accept`, `symbols` and `find`, and earns one line of JSON.";

/// See how an answer would be marked, and why
///
/// Compares what a student might write with a model answer: the verdict, how the answer was read, and what a teacher
/// would say.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct CompareArguments {
    /// The model answer, such as `6*sin(10*deg)`
    #[arg(value_name = "MODEL", required_unless_present = "stream", allow_hyphen_values = true)]
    model: Option<String>,
    /// What the student wrote
    #[arg(value_name = "ANSWER", required_unless_present = "stream", allow_hyphen_values = true)]
    answer: Option<String>,
    /// The kind of answer; left out, it is inferred from the model
    #[arg(long, value_name = "KIND")]
    kind: Option<String>,
    /// The rule of acceptance: `exact`, `awrt 3sf`, `3sf`, `2dp`, `nearest 1`
    #[arg(long, value_name = "RULE")]
    accept: Option<String>,
    /// Letters with their ranges: `u=positive,e=unit,alpha=acute,x=real`
    #[arg(long, value_name = "LETTERS", value_delimiter = ',')]
    symbols: Vec<String>,
    /// What is asked for: a quantity such as `A.after.speed`, whose unit is then known, both components of a vector, as
    /// `A.after.x,A.after.y`, or a letter of `--symbols`
    #[arg(long, value_name = "QUANTITY")]
    find: Option<String>,
    /// Print the verdict as JSON
    #[arg(long)]
    json: bool,
    /// Read JSON lines from stdin and write one verdict for each
    #[arg(long, conflicts_with_all = ["model", "answer", "kind", "accept", "symbols", "find", "json"])]
    stream: bool,
}

/// Compares.
pub fn run(arguments: &CompareArguments) -> Result<(), Failure> {
    let (Some(model), Some(answer)) = (&arguments.model, &arguments.answer) else {
        return compare_stream::run(std::io::stdin().lock(), std::io::stdout().lock());
    };
    let letters = arguments.symbols.iter().map(|symbol| match symbol.split_once('=') {
        Some((name, range)) => declared(name.trim(), range.trim()),
        None => Err(Wrong::plain(format!("`{symbol}` declares no letter"), "write `u=positive`")),
    });
    let letters = letters.collect::<Result<Vec<_>, _>>()?;
    let asked = arguments.find.as_deref().map(|find| Asked::read(find, &letters)).transpose()?.unwrap_or_default();
    let options = ModelOptions {
        kind: arguments.kind.as_deref().map(kind).transpose()?,
        accept: arguments.accept.as_deref().map(accept).transpose()?,
        letters,
        quantity: asked.quantity,
        letter: asked.letter,
    };
    let model = Model::read(model, &options).map_err(|fault| Failure::Faults(vec![diagnosed(fault, model)]))?;
    let judgement = judge(&model, &read_answer(answer, &model.vocabulary));
    if arguments.json { print_json(&as_json(&judgement)) } else { print(&in_words(&judgement)) }
}

/// The exchange format of a verdict.
pub(super) fn as_json(judgement: &Judgement) -> Json {
    json!({
        "verdict": judgement.verdict.name(),
        "reading": judgement.reading,
        "note": judgement.note,
        "feedback": judgement.feedback,
    })
}

fn in_words(judgement: &Judgement) -> String {
    let mut text = judgement.verdict.name().to_owned();
    if let Some(note) = judgement.note {
        text.push_str(&format!(" ({note})"));
    }
    text.push('\n');
    if let Some(reading) = &judgement.reading {
        text.push_str(&format!("read as  {reading}\n"));
    }
    text.push_str(&format!("{}\n", judgement.feedback));
    text
}

/// What is wrong with an option, and one thing to try.
pub(super) struct Wrong {
    pub(super) message: String,
    pub(super) help: String,
}

impl Wrong {
    fn plain(message: impl Into<String>, help: impl Into<String>) -> Wrong {
        Wrong { message: message.into(), help: help.into() }
    }

    /// A name that is none of those there are.
    fn name<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str> + Clone) -> Wrong {
        let help = match near(name, known.clone()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", listed(known)),
        };
        Wrong::plain(format!("unknown {what} `{name}`"), help)
    }
}

impl From<Wrong> for Failure {
    fn from(wrong: Wrong) -> Failure {
        Failure::with_help(wrong.message, wrong.help)
    }
}

/// A kind by its name.
pub(super) fn kind(name: &str) -> Result<Kind, Wrong> {
    name.parse().map_err(|_| Wrong::name("kind of answer", name, Kind::ALL.into_iter().map(Kind::name)))
}

/// A rule of acceptance.
pub(super) fn accept(words: &str) -> Result<Accept, Wrong> {
    let help = "write `exact`, `awrt 3sf`, `3sf`, `2dp`, `nearest 1` or `nearest degree`; `or better`, `cao`, `oe` and `isw` may follow";
    Accept::said(words).map_err(|_| Wrong::plain(format!("unknown rule of acceptance `{words}`"), help))
}

/// What is asked for, as the `find` of a key says it.
#[derive(Clone, Default, PartialEq)]
pub(super) struct Asked {
    /// Of a vector the first component.
    pub(super) quantity: Option<Quantity>,
    /// A letter that is to be found.
    pub(super) letter: Option<String>,
}

impl Asked {
    /// A quantity, two components with a comma between them, or one of the letters.
    pub(super) fn read(find: &str, letters: &[Letter]) -> Result<Asked, Wrong> {
        let find = find.trim();
        if letters.iter().any(|letter| letter.name() == find) {
            return Ok(Asked { quantity: None, letter: Some(find.to_owned()) });
        }
        let quantities = find.split(',').map(|name| quantity(name.trim())).collect::<Result<Vec<_>, _>>()?;
        Ok(Asked { quantity: quantities.first().copied(), letter: None })
    }
}

/// A quantity by its name.
fn quantity(name: &str) -> Result<Quantity, Wrong> {
    let names: Vec<String> = Quantity::all().iter().map(Quantity::to_string).collect();
    name.parse().map_err(|_| match near(name, names.iter().map(String::as_str)) {
        Some(near) => Wrong::plain(format!("unknown quantity `{name}`"), format!("did you mean `{near}`?")),
        None => Wrong::plain(format!("unknown quantity `{name}`"), "write it as in a key: `A.after.speed`"),
    })
}

/// A letter with its range.
pub(super) fn declared(name: &str, range: &str) -> Result<Letter, Wrong> {
    let ranges = Range::DECLARED;
    let found = ranges.iter().find(|(word, _)| *word == range);
    let range = found.ok_or_else(|| Wrong::name("range", range, ranges.iter().map(|(word, _)| *word)))?.1;
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic());
    Letter::new(name, range)
        .filter(|_| is_name)
        .ok_or_else(|| Wrong::plain(format!("`{name}` is no name of a letter"), "write `u=positive`"))
}

/// A fault in the text of a model.
pub(super) fn diagnosed(fault: Fault, model: &str) -> Diagnostic {
    let source = Source::new("model", model);
    let diagnostic = Diagnostic::new(fault.message, &source, fault.span.start..fault.span.end, fault.expected);
    Diagnostic { help: fault.help, ..diagnostic }
}
