//! Cost against error, both on scales of powers of ten; what is exact has a band of its own at the foot.

use super::canvas::{Anchor, Area, Canvas, Shape, Tone};
use super::labels::{Label, place, together};
use super::scale::{Decades, power};

/// What kind of thing a series is: one colour and one mark each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Work {
    /// Exact numbers.
    Exact,
    /// Numbers that say how sure they are.
    Certified,
    /// Doubles in some arrangement.
    Double,
    /// Less or more than double precision.
    OtherPrecision,
    /// Contact simulated in time.
    Simulated,
    /// Other programs.
    Peer,
}

impl Work {
    /// All of them, in the order of the legend.
    pub const ALL: [Work; 6] =
        [Work::Exact, Work::Certified, Work::Double, Work::OtherPrecision, Work::Simulated, Work::Peer];

    /// In the legend.
    pub fn words(self) -> &'static str {
        match self {
            Work::Exact => "exact numbers",
            Work::Certified => "with a proved bound",
            Work::Double => "doubles",
            Work::OtherPrecision => "other precisions",
            Work::Simulated => "simulated in time",
            Work::Peer => "other programs",
        }
    }

    fn look(self) -> (Tone, Shape) {
        match self {
            Work::Exact => (Tone::Ink, Shape::Star),
            Work::Certified => (Tone::Green, Shape::Square),
            Work::Double => (Tone::Blue, Shape::Circle),
            Work::OtherPrecision => (Tone::Purple, Shape::Diamond),
            Work::Simulated => (Tone::Vermilion, Shape::Triangle),
            Work::Peer => (Tone::Orange, Shape::Cross),
        }
    }
}

/// A method with what it costs and how far it is off: one point, or a curve over sizes of step.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// What kind it is.
    pub work: Work,
    /// Nanoseconds for an impact, and the worst error, which is nought for what is exact.
    pub points: Vec<(f64, f64)>,
}

const WIDTH: f64 = 960.0;
const LETTERS: f64 = 11.0;
/// Errors below this have a strip of their own, with the power beside the name: the scale is for those that differ.
const FAR: f64 = 1e-18;
/// The height of that strip.
const STRIP: f64 = 26.0;
/// The height of the band of what is exact.
const BAND: f64 = 190.0;

/// The chart, and how many of its labels found no room.
pub fn scatter(series: &[Series], words: &str) -> (String, usize) {
    let mut canvas = Canvas::new(WIDTH, 960.0);
    let frame = Area { left: 78.0, top: 56.0, right: WIDTH - 14.0, bottom: 960.0 - 56.0 };
    let floor = frame.bottom - BAND;
    let points = || series.iter().flat_map(|series| series.points.iter());
    let across = Decades::over(points().map(|(cost, _)| *cost), frame.left + 60.0, frame.right - 30.0);
    let near = points().map(|(_, error)| *error).filter(|error| *error >= FAR);
    let up = Decades::over(near.chain([1.0, 1e-21]), floor - STRIP - 6.0, frame.top + 10.0);
    axes(&mut canvas, frame, floor, &across, &up);
    legend(&mut canvas, frame, series);
    let at = |(cost, error): &(f64, f64)| {
        let y = match *error {
            0.0 => floor + BAND / 2.0,
            error if error < FAR => floor - STRIP / 2.0,
            error => up.place(error),
        };
        (across.place(*cost), y)
    };
    for one in series {
        let (tone, shape) = one.work.look();
        let places: Vec<(f64, f64)> = one.points.iter().map(at).collect();
        for pair in places.windows(2) {
            canvas.line(pair[0], pair[1], tone, 1.4, "");
            take_line(&mut canvas, pair[0], pair[1]);
        }
        for place in places {
            canvas.mark(place, shape, tone, 5.0);
            let area = Area::around(place.0, place.1, 6.0);
            canvas.take(area);
            canvas.marked.push(area);
        }
    }
    let last = |one: &Series| {
        let point = one.points.last()?;
        let far = point.1 > 0.0 && point.1 < FAR;
        let name =
            if far { format!("{}: {}", one.name, power(point.1.log10().round() as i32)) } else { one.name.clone() };
        Some((at(point), name))
    };
    let labels = together(series.iter().filter_map(last));
    let (above, below): (Vec<Label>, Vec<Label>) = labels.into_iter().partition(|label| label.mark.1 < floor);
    let upper = Area { bottom: floor, ..frame };
    let lower = Area { top: floor + 16.0, ..frame };
    let missing = place(&mut canvas, upper, LETTERS, &above) + place(&mut canvas, lower, LETTERS, &below);
    (canvas.finish(words), missing)
}

fn axes(canvas: &mut Canvas, frame: Area, floor: f64, across: &Decades, up: &Decades) {
    for exponent in across.ticks(50.0) {
        let x = across.place(10f64.powi(exponent));
        canvas.line((x, frame.top), (x, frame.bottom), Tone::Grid, 1.0, "");
        canvas.text((x, frame.bottom + 17.0), Anchor::Middle, 12.0, Tone::Ink, &power(exponent));
    }
    for exponent in up.ticks(34.0) {
        let y = up.place(10f64.powi(exponent));
        canvas.line((frame.left, y), (frame.right, y), Tone::Grid, 1.0, "");
        canvas.text((frame.left - 8.0, y + 4.0), Anchor::End, 12.0, Tone::Ink, &power(exponent));
    }
    // The words stand where the chart is empty: nothing quick is rough, and nothing slow is as good as a double.
    let lines = [(5e-4, "half a unit in the third figure", true), (1.1e-16, "roundoff of a double", false)];
    for (error, words, at_left) in lines {
        let y = up.place(error);
        if y > floor {
            continue;
        }
        canvas.line((frame.left, y), (frame.right, y), Tone::Faint, 1.2, "5 4");
        let width = Canvas::width_of(words, LETTERS) + 6.0;
        let left = if at_left { frame.left + 6.0 } else { frame.right - width };
        let (x, anchor) = if at_left { (left, Anchor::Start) } else { (frame.right - 6.0, Anchor::End) };
        canvas.text((x, y - 5.0), anchor, LETTERS, Tone::Faint, words);
        let words = Area { left, right: left + width, top: y - 17.0, bottom: y - 1.0 };
        canvas.take(words);
        canvas.written.push(words);
        canvas.take(Area { left: frame.left, right: frame.right, top: y - 0.8, bottom: y + 0.8 });
    }
    canvas.line((frame.left, floor), (frame.right, floor), Tone::Ink, 1.2, "");
    canvas.line((frame.left, floor - STRIP), (frame.right, floor - STRIP), Tone::Faint, 1.0, "");
    canvas.text((frame.left + 8.0, floor - 9.0), Anchor::Start, LETTERS, Tone::Faint, "smaller by far");
    canvas.take(Area { left: frame.left, right: frame.left + 110.0, top: floor - STRIP, bottom: floor });
    canvas.take(Area { top: floor - STRIP - 1.0, bottom: floor - STRIP + 1.0, ..frame });
    canvas.line((frame.left, floor + BAND / 2.0), (frame.right, floor + BAND / 2.0), Tone::Grid, 1.0, "");
    canvas.strong((frame.left + 8.0, floor + 15.0), Anchor::Start, LETTERS + 1.0, "exact: error 0");
    for (from, to) in [
        ((frame.left, frame.top), (frame.left, frame.bottom)),
        ((frame.left, frame.bottom), (frame.right, frame.bottom)),
    ] {
        canvas.line(from, to, Tone::Ink, 1.2, "");
    }
    let middle = ((frame.left + frame.right) / 2.0, frame.bottom + 42.0);
    canvas.text(middle, Anchor::Middle, 13.0, Tone::Ink, "cost of one impact in nanoseconds");
    canvas.upright(
        (20.0, (frame.top + floor) / 2.0),
        13.0,
        "worst error of a velocity, as a part of the largest speed",
    );
}

fn legend(canvas: &mut Canvas, frame: Area, series: &[Series]) {
    let mut x = frame.left;
    for work in Work::ALL {
        if !series.iter().any(|series| series.work == work) {
            continue;
        }
        let (tone, shape) = work.look();
        canvas.mark((x + 7.0, 26.0), shape, tone, 5.0);
        canvas.text((x + 18.0, 30.0), Anchor::Start, 12.0, Tone::Ink, work.words());
        x += 18.0 + Canvas::width_of(work.words(), 12.0) + 12.0;
    }
}

/// Takes the room of a line, in small pieces.
fn take_line(canvas: &mut Canvas, (x, y): (f64, f64), (p, q): (f64, f64)) {
    let count = ((p - x).hypot(q - y) / 4.0).ceil().max(1.0) as u32;
    for step in 0..=count {
        let part = f64::from(step) / f64::from(count);
        canvas.take(Area::around(x + part * (p - x), y + part * (q - y), 2.5));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_label_finds_a_place_in_a_crowd() {
        // Thirty methods within two decades of cost, half of them exact.
        let series: Vec<Series> = (0..30)
            .map(|n| Series {
                name: format!("method-number-{n}"),
                work: Work::ALL[n % 6],
                points: vec![(1.2f64.powi(n as i32), if n % 2 == 0 { 0.0 } else { 1e-16 * (n as f64) })],
            })
            .collect();
        let (svg, missing) = scatter(&series, "a crowd");
        assert_eq!(missing, 0);
        assert!(series.iter().all(|one| svg.contains(&format!(">{}<", one.name))), "{svg}");
    }

    #[test]
    fn what_is_exact_stands_below_every_error() {
        let one = |name: &str, error| Series { name: name.to_owned(), work: Work::Exact, points: vec![(1.0, error)] };
        let (svg, _) = scatter(&[one("exact", 0.0), one("double", 1e-16)], "two");
        let stars = svg.lines().filter(|line| line.contains("f ink\" d=\"M")).count();
        assert!(stars >= 2, "{svg}");
    }
}
