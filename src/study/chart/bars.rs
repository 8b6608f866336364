//! Rows with marks on one scale of powers of ten: what tiers cost, how wide a tolerance must be.

use super::canvas::{Anchor, Area, Canvas, Shape, Tone};
use super::scale::{Decades, power};

/// A row of the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Its name; nothing if it goes with the row above.
    pub name: String,
    /// What is said at its end.
    pub says: String,
    /// One number for each of the marks of the chart; nought for none.
    pub values: Vec<f64>,
}

/// What the chart says around its rows.
#[derive(Clone, Copy, Debug)]
pub struct Bars<'c> {
    /// Under the scale.
    pub scale: &'c str,
    /// In the legend, one for each number of a row.
    pub marks: &'c [&'c str],
    /// Are they bars from the left edge, or marks on a line?
    pub bars: bool,
    /// For those who cannot see it.
    pub words: &'c str,
}

const WIDTH: f64 = 960.0;
const ROW: f64 = 24.0;
const TOP: f64 = 44.0;

/// The chart.
pub fn bars(chart: Bars, rows: &[Bar]) -> String {
    let name = rows.iter().map(|row| Canvas::width_of(&row.name, 12.0)).fold(60.0, f64::max);
    let says = rows.iter().map(|row| Canvas::width_of(&row.says, 11.0)).fold(20.0, f64::max);
    let bottom = TOP + rows.len() as f64 * ROW + 4.0;
    let mut canvas = Canvas::new(WIDTH, bottom + 54.0);
    let (left, right) = (name + 20.0, WIDTH - says - 24.0);
    let all = rows.iter().flat_map(|row| row.values.iter().copied());
    let scale = Decades::over(all, left, right);
    for exponent in scale.ticks(50.0) {
        let x = scale.place(10f64.powi(exponent));
        canvas.line((x, TOP - 6.0), (x, bottom), Tone::Grid, 1.0, "");
        canvas.text((x, bottom + 17.0), Anchor::Middle, 12.0, Tone::Ink, &power(exponent));
    }
    canvas.text(((left + right) / 2.0, bottom + 42.0), Anchor::Middle, 13.0, Tone::Ink, chart.scale);
    let mut x = left;
    for (place, words) in chart.marks.iter().enumerate() {
        let shape = if chart.bars { Shape::Square } else { Shape::SERIES[place % 8] };
        canvas.mark((x + 6.0, 18.0), shape, Tone::SERIES[place % 7], 5.0);
        canvas.text((x + 17.0, 22.0), Anchor::Start, 12.0, Tone::Ink, words);
        x += 17.0 + Canvas::width_of(words, 12.0) + 18.0;
    }
    for (place, row) in rows.iter().enumerate() {
        let y = TOP + place as f64 * ROW + ROW / 2.0;
        canvas.text((left - 10.0, y + 4.0), Anchor::End, 12.0, Tone::Ink, &row.name);
        let shown: Vec<(usize, f64)> =
            row.values.iter().copied().enumerate().filter(|(_, value)| *value > 0.0 && value.is_finite()).collect();
        if chart.bars {
            for (mark, value) in &shown {
                let area = Area { left, top: y - 8.0, right: scale.place(*value), bottom: y + 8.0 };
                canvas.bar(area, Tone::SERIES[mark % 7]);
            }
        } else {
            if let (Some(first), Some(last)) = (shown.first(), shown.last()) {
                canvas.line((scale.place(first.1), y), (scale.place(last.1), y), Tone::Faint, 1.2, "");
            }
            for (mark, value) in &shown {
                canvas.mark((scale.place(*value), y), Shape::SERIES[mark % 8], Tone::SERIES[mark % 7], 5.0);
            }
        }
        canvas.text((right + 12.0, y + 4.0), Anchor::Start, 11.0, Tone::Faint, &row.says);
    }
    canvas.line((left, TOP - 6.0), (left, bottom), Tone::Ink, 1.2, "");
    canvas.finish(chart.words)
}
