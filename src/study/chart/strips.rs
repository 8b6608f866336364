//! Maps of stability: a strip for each arrangement, a cell for each k, and in it how many figures are right.
//!
//! A cell says its number, so that nothing depends on its colour alone. A thick line stands where three figures are lost.

use super::canvas::{Anchor, Area, Canvas, Tone};
use crate::study::double::Outcome;
use crate::study::map::{Map, Row};

/// Half a unit in the third figure, at its worst.
pub const THREE_FIGURES: f64 = 5e-4;

/// From no figure right to all: dark blue to pale yellow, as the eye takes it for less and more with any colour vision.
const COLOURS: [&str; 17] = [
    "#00204d", "#002b66", "#12366f", "#27416c", "#374c6b", "#45576c", "#52626e", "#5f6d72", "#6c7876", "#7a8478",
    "#898f78", "#989c76", "#a8a971", "#b9b66a", "#cbc45f", "#ddd251", "#ffea46",
];
const EXACT: &str = "#e3f1fb";

const WIDTH: f64 = 960.0;
const GUTTER: f64 = 24.0;
const CELL: f64 = 17.0;
const TALL: f64 = 16.0;
const HEAD: f64 = 40.0;
const LETTERS: f64 = 10.5;

/// Maps under each other in two columns, with a legend at the foot.
pub fn strips(maps: &[Map], words: &str) -> String {
    let mut columns: [Vec<&Map>; 2] = Default::default();
    let mut heights = [0.0, 0.0];
    for map in maps {
        let side = usize::from(heights[1] < heights[0]);
        heights[side] += height(map);
        columns[side].push(map);
    }
    let foot = heights[0].max(heights[1]) + 14.0;
    let mut canvas = Canvas::new(WIDTH, foot + 62.0);
    for (side, column) in columns.iter().enumerate() {
        let mut top = 10.0;
        let left = side as f64 * (WIDTH + GUTTER) / 2.0 + 8.0;
        for map in column {
            draw(&mut canvas, left, top, map);
            top += height(map);
        }
    }
    legend(&mut canvas, foot);
    canvas.finish(words)
}

fn height(map: &Map) -> f64 {
    let refusing = if shown(map).count() < map.rows.len() { 16.0 } else { 0.0 };
    HEAD + shown(map).count() as f64 * TALL + 34.0 + refusing
}

/// Rows that are drawn; what refuses every scene is only named.
fn shown(map: &Map) -> impl Iterator<Item = &Row> {
    map.rows.iter().filter(|row| !refuses(row))
}

fn refuses(row: &Row) -> bool {
    row.worst.iter().all(|outcome| *outcome == Outcome::Refused)
}

fn draw(canvas: &mut Canvas, left: f64, top: f64, map: &Map) {
    canvas.strong((left, top + 13.0), Anchor::Start, 12.5, &capital(&map.quantity));
    canvas.text((left, top + 29.0), Anchor::Start, 11.0, Tone::Faint, &map.regime);
    let columns = map.rows.first().map_or(0, |row| row.worst.len());
    let room = (WIDTH - GUTTER) / 2.0 - 12.0;
    let start = left + room - columns as f64 * CELL;
    for (place, row) in shown(map).enumerate() {
        let y = top + HEAD + place as f64 * TALL;
        canvas.text((start - 6.0, y + 12.0), Anchor::End, LETTERS, Tone::Ink, &row.arrangement);
        for (column, outcome) in row.worst.iter().enumerate() {
            let x = start + column as f64 * CELL;
            let area = Area { left: x, top: y, right: x + CELL - 1.0, bottom: y + TALL - 1.0 };
            let (text, colour, on) = cell(*outcome);
            canvas.cell(area, colour);
            canvas.text_on_cell((x + CELL / 2.0 - 0.5, y + 11.5), 9.5, on, &text);
        }
        boundary(canvas, start, y, row);
    }
    let y = top + HEAD + shown(map).count() as f64 * TALL + 12.0;
    canvas.text((start - 6.0, y), Anchor::End, LETTERS, Tone::Faint, "k");
    for column in 0..columns {
        let x = start + column as f64 * CELL + CELL / 2.0;
        canvas.text((x, y), Anchor::Middle, 9.5, Tone::Faint, &(map.first + column as u32).to_string());
    }
    let refusing: Vec<&str> = map.rows.iter().filter(|row| refuses(row)).map(|row| row.arrangement.as_str()).collect();
    if !refusing.is_empty() {
        let words = format!("refused by {}", refusing.join(", "));
        canvas.text((left, y + 16.0), Anchor::Start, fitting(&words, room), Tone::Faint, &words);
    }
}

/// The size of letters with which a line of words fits into its column.
fn fitting(words: &str, room: f64) -> f64 {
    (LETTERS * room / Canvas::width_of(words, LETTERS)).min(LETTERS)
}

/// The line where three figures are lost.
fn boundary(canvas: &mut Canvas, start: f64, y: f64, row: &Row) {
    for (column, pair) in row.worst.windows(2).enumerate() {
        if pair[0].within(THREE_FIGURES) != pair[1].within(THREE_FIGURES) {
            let x = start + (column + 1) as f64 * CELL - 0.5;
            canvas.line((x, y - 0.5), (x, y + TALL - 0.5), Tone::Vermilion, 3.0, "");
        }
    }
}

/// The words of a cell, its colour, and that of its words.
fn cell(outcome: Outcome) -> (String, &'static str, &'static str) {
    match outcome {
        Outcome::Off(0.0) => ("=".to_owned(), EXACT, "#111111"),
        Outcome::Off(error) => {
            let figures = figures(error);
            (figures.to_string(), COLOURS[figures], if figures < 10 { "#ffffff" } else { "#111111" })
        }
        Outcome::NoNumber => ("×".to_owned(), COLOURS[0], "#ffffff"),
        Outcome::Refused => ("–".to_owned(), "#c8c8c8", "#111111"),
    }
}

/// How many figures are right: the powers of ten by which the error is smaller than the value.
pub fn figures(error: f64) -> usize {
    (0..16).take_while(|figure| error < format!("1e-{}", figure + 1).parse().unwrap_or(0.0)).count()
}

fn legend(canvas: &mut Canvas, top: f64) {
    let mut x = 8.0;
    canvas.text((x, top + 12.0), Anchor::Start, 11.0, Tone::Ink, "figures that are right:");
    x += 150.0;
    for (figures, colour) in COLOURS.iter().enumerate() {
        canvas.cell(Area { left: x, top, right: x + CELL, bottom: top + TALL }, colour);
        let on = if figures < 10 { "#ffffff" } else { "#111111" };
        canvas.text_on_cell((x + CELL / 2.0, top + 11.5), 9.5, on, &figures.to_string());
        x += CELL;
    }
    let mut x = 8.0;
    for (sign, colour, on, words) in [
        ("=", EXACT, "#111111", "exact"),
        ("×", COLOURS[0], "#ffffff", "no number, or something for nought"),
        ("–", "#c8c8c8", "#111111", "refused"),
    ] {
        let y = top + 24.0;
        canvas.cell(Area { left: x, top: y, right: x + CELL, bottom: y + TALL }, colour);
        canvas.text_on_cell((x + CELL / 2.0, y + 11.5), 9.5, on, sign);
        canvas.text((x + CELL + 6.0, y + 12.0), Anchor::Start, 11.0, Tone::Ink, words);
        x += CELL + 6.0 + Canvas::width_of(words, 11.0) + 20.0;
    }
    canvas.line((x + 4.0, top + 23.5), (x + 4.0, top + 40.5), Tone::Vermilion, 3.0, "");
    canvas.text((x + 14.0, top + 36.0), Anchor::Start, 11.0, Tone::Ink, "three figures are lost here");
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_counted_by_powers_of_ten() {
        for (error, right) in [(1e-17, 16), (5e-17, 16), (2e-16, 15), (5e-4, 3), (0.02, 1), (0.5, 0), (30.0, 0)] {
            assert_eq!(figures(error), right, "{error}");
        }
    }
}
