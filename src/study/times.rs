//! The table of times as CSV: written by a study, and read back from one, or from a script that ran other programs.

use std::ops::Range;

use super::chart::Work;
use super::work::Cost;
use crate::diagnostic::{Diagnostic, Source, near};

/// The columns.
const COLUMNS: [&str; 7] = ["name", "kind", "scene", "steps", "nanoseconds", "ratio", "error"];

impl Work {
    /// In the column `kind`.
    pub fn name(self) -> &'static str {
        match self {
            Work::Exact => "exact",
            Work::Certified => "certified",
            Work::Double => "double",
            Work::OtherPrecision => "other-precision",
            Work::Simulated => "simulated",
            Work::Peer => "peer",
        }
    }
}

/// The table as text.
pub fn write_times(costs: &[Cost]) -> String {
    let mut text = COLUMNS.join(",") + "\n";
    for cost in costs {
        let steps = cost.steps.map_or(String::new(), |steps| steps.to_string());
        let error = cost.error.map_or(String::new(), |error| format!("{error:.2e}"));
        let row = format!(
            "{},{},{},{steps},{:.3},{:.3},{error}\n",
            cost.name,
            cost.work.name(),
            cost.scene,
            cost.nanoseconds,
            cost.ratio
        );
        text.push_str(&row);
    }
    text
}

/// Reads a table, or says everything that is wrong with it.
pub fn read_times(source: &Source) -> Result<Vec<Cost>, Vec<Diagnostic>> {
    let (mut costs, mut faults) = (Vec::new(), Vec::new());
    let mut lines = lines(&source.text);
    let header = lines.next().unwrap_or((0..0, ""));
    if header.1.split(',').map(str::trim).ne(COLUMNS) {
        let message = "this is no table of times";
        let label = format!("expected the columns `{}`", COLUMNS.join(","));
        let fault = Diagnostic::new(message, source, header.0, label);
        return Err(vec![fault.with_help("`carom study --out DIR` writes such a table, and so does benches/peers.py")]);
    }
    for (span, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        match row(source, span, line) {
            Ok(cost) => costs.push(cost),
            Err(fault) => faults.push(*fault),
        }
    }
    if faults.is_empty() { Ok(costs) } else { Err(faults) }
}

fn row(source: &Source, span: Range<usize>, line: &str) -> Result<Cost, Box<Diagnostic>> {
    let fault = |message: String, span: &Range<usize>, label: String| {
        Box::new(Diagnostic::new(message, source, span.clone(), label))
    };
    let cells: Vec<(Range<usize>, &str)> = cells(span.start, line);
    let [name, kind, scene, steps, nanoseconds, ratio, error] = cells.as_slice() else {
        let message = format!("a row with {} cells", cells.len());
        return Err(fault(message, &span, format!("expected {}", COLUMNS.len())));
    };
    let Some(work) = Work::ALL.into_iter().find(|work| work.name() == kind.1) else {
        let names = Work::ALL.map(Work::name);
        let label = format!("expected one of `{}`", names.join("`, `"));
        let unknown = fault(format!("unknown kind `{}`", kind.1), &kind.0, label);
        return Err(Box::new(unknown.with_near(near(kind.1, names))));
    };
    let positive = |(span, text): &(Range<usize>, &str)| match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err(fault(format!("`{text}` is no time"), span, "expected a positive number".to_owned())),
    };
    let empty_or = |(_, text): &(Range<usize>, &str)| text.is_empty();
    let wrong = |(span, text): &(Range<usize>, &str), expected: &str| {
        fault(format!("`{text}` is not {expected}"), span, format!("expected {expected}"))
    };
    let error = match error {
        cell if empty_or(cell) => None,
        cell => match cell.1.parse::<f64>() {
            Ok(number) if number >= 0.0 && number.is_finite() => Some(number),
            _ => return Err(wrong(cell, "an error from 0 up, or nothing")),
        },
    };
    let steps = match steps {
        cell if empty_or(cell) => None,
        cell => Some(cell.1.parse().map_err(|_| wrong(cell, "a number of steps, or nothing"))?),
    };
    if name.1.is_empty() || name.1.chars().any(char::is_control) {
        return Err(wrong(name, "the name of a method"));
    }
    Ok(Cost {
        name: name.1.to_owned(),
        work,
        scene: scene.1.to_owned(),
        steps,
        nanoseconds: positive(nanoseconds)?,
        ratio: positive(ratio)?,
        error,
    })
}

/// Lines with their places.
fn lines(text: &str) -> impl Iterator<Item = (Range<usize>, &str)> {
    let mut start = 0;
    text.split('\n').map(move |line| {
        let begun = start;
        start += line.len() + 1;
        let line = line.trim_end_matches('\r');
        (begun..begun + line.len(), line)
    })
}

/// Cells with their places; these tables need no quotes.
fn cells(mut start: usize, line: &str) -> Vec<(Range<usize>, &str)> {
    let cell = |cell| {
        let begun = start;
        start += str::len(cell) + 1;
        let text = cell.trim();
        let before = cell.len() - cell.trim_start().len();
        (begun + before..begun + before + text.len(), text)
    };
    line.split(',').map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_comes_back_as_it_was_written() {
        let cost = Cost {
            name: "verlet".to_owned(),
            work: Work::Simulated,
            scene: "oblique".to_owned(),
            steps: Some(100),
            nanoseconds: 1234.5,
            ratio: 800.25,
            error: Some(3.5e-3),
        };
        let costs = [cost.clone(), Cost { steps: None, error: None, ..cost }];
        assert_eq!(read_times(&Source::new("times.csv", write_times(&costs))).unwrap(), costs);
    }

    #[test]
    fn what_is_wrong_is_shown_where_it_is() {
        let head = COLUMNS.join(",");
        for (row, place) in [
            ("a,doubles,x,,1,1,", "doubles"),
            ("a,double,x,,-1,1,", "-1"),
            ("a,double,x,,1,nan,", "nan"),
            ("a,double,x,1.5,1,1,", "1.5"),
            ("a,double,x,,1,1,big", "big"),
            ("a,double", "a,double"),
        ] {
            let source = Source::new("t.csv", format!("{head}\n{row}\n"));
            let faults = read_times(&source).unwrap_err();
            assert_eq!(faults.len(), 1, "{row}");
            assert_eq!(&source.text[faults[0].span.clone()], place, "{row}");
            assert_eq!(faults[0].line(), 2);
        }
        assert!(read_times(&Source::new("t.csv", "")).is_err());
    }
}
