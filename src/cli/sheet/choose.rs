//! The questions of a sheet: chosen as the arguments ask, and checked.

use std::collections::{BTreeMap, HashSet};

use super::super::bank;
use super::super::failure::Failure;
use super::super::output::listed;
use super::SheetArguments;
use crate::bank::{Contents, Heading, Question, StyleName};
use crate::diagnostic::near;
use crate::paper::{choose_count, choose_marks};

/// How many questions a sheet has if nobody says.
const USUAL_COUNT: usize = 6;

/// The headings of the questions of the sheet, in its order, with repeats.
pub(super) fn choose<'c>(
    arguments: &SheetArguments,
    contents: &'c Contents,
    style: Option<StyleName>,
    seed: u64,
) -> Result<Vec<&'c Heading>, Failure> {
    let mut named = Vec::new();
    for name in &arguments.questions {
        named.push(bank::find(contents, name)?);
    }
    let has_style = |heading: &&Heading| style.is_none_or(|style| heading.styles.contains(&style));
    if let Some(heading) = named.iter().find(|heading| !has_style(heading)) {
        let styles = listed(heading.styles.iter().map(|style| style.name()));
        let style = style.map_or("", StyleName::name);
        return Err(Failure::with_help(format!("`{}` has no style `{style}`", heading.id), format!("it has {styles}")));
    }
    let mut offered: Vec<&Heading> = if named.is_empty() { contents.headings.iter().collect() } else { named.clone() };
    if let Some(topic) = &arguments.topic {
        offered = of_topic(&offered, topic)?;
    }
    offered.retain(has_style);
    if offered.is_empty() {
        return Err(Failure::with_help("no question has this style", "leave out `--style`, or name other questions"));
    }
    if arguments.reference {
        // Of all questions those with an exercise behind them; of questions that are named, their own numbers.
        if arguments.topic.is_none() && arguments.questions.is_empty() {
            let (exercises, others): (Vec<&Heading>, Vec<&Heading>) =
                offered.iter().partition(|heading| heading.mirrors.is_some());
            return Ok(if exercises.is_empty() { others } else { exercises });
        }
        return Ok(offered);
    }
    match (arguments.count.map(usize::from), arguments.marks) {
        (_, Some(marks)) => {
            let chosen = choose_marks(&offered, usize::from(marks), seed);
            if chosen.is_empty() {
                let least = offered.iter().map(|heading| heading.marks).min().unwrap_or(0);
                let message = format!("no question has so few marks: the shortest has {least}");
                return Err(Failure::with_help(message, format!("ask for as many at least: `--marks {least}`")));
            }
            Ok(chosen)
        }
        (Some(wanted), None) if !named.is_empty() => Ok(offered.iter().cycle().take(wanted).copied().collect()),
        (None, None) if !named.is_empty() => Ok(offered),
        (wanted, None) => {
            let usual = if arguments.topic.is_some() { USUAL_COUNT.min(offered.len()) } else { USUAL_COUNT };
            Ok(choose_count(&offered, wanted.unwrap_or(usual), seed))
        }
    }
}

fn of_topic<'c>(offered: &[&'c Heading], topic: &str) -> Result<Vec<&'c Heading>, Failure> {
    let wanted = topic.trim().to_lowercase();
    let exact: Vec<&Heading> =
        offered.iter().filter(|heading| heading.topic.to_lowercase() == wanted).copied().collect();
    if !exact.is_empty() {
        return Ok(exact);
    }
    let within: Vec<&Heading> =
        offered.iter().filter(|heading| heading.topic.to_lowercase().contains(&wanted)).copied().collect();
    if !within.is_empty() {
        return Ok(within);
    }
    let mut topics: Vec<&str> = offered.iter().map(|heading| heading.topic.as_str()).collect();
    topics.sort_unstable();
    topics.dedup();
    let help = match near(topic, topics.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("the topics are {}", listed(topics)),
    };
    Err(Failure::with_help(format!("no question of topic `{topic}`"), help))
}

/// The questions that are used, each checked once; faults of all of them together.
pub(super) fn checked<'c>(chosen: &[&'c Heading]) -> Result<BTreeMap<&'c str, Question>, Failure> {
    let mut questions = BTreeMap::new();
    let mut faults = Vec::new();
    let mut seen = HashSet::new();
    for heading in chosen {
        if !seen.insert(heading.id.as_str()) {
            continue;
        }
        match heading.question() {
            Ok(question) => {
                questions.insert(heading.id.as_str(), question);
            }
            Err(found) => faults.extend(found),
        }
    }
    if faults.is_empty() { Ok(questions) } else { Err(Failure::Faults(faults)) }
}
