//! A picture judged by its ink: it shows the strokes of its drawing, and no label touches another or a stroke.

use carom::diagram::{Drawing, Label, Point, Section, Stroke, Style};
use carom::expr::print;

use super::ink::{Area, Ink, along};

/// How far from each other two labels stand at least, in ems.
const BETWEEN_LABELS: f64 = 0.12;

/// How far a label stands from a stroke at least.
const FROM_STROKES: f64 = 0.08;

/// By how much a label may be larger than the box that is kept free for it.
const FORGIVEN: f64 = 0.15;

/// How exactly a stroke is where the drawing says.
const EXACT: f64 = 0.06;

/// What is wrong with a picture that shows a drawing, its ink in the drawing's own places.
pub fn faults(drawing: &Drawing, ink: &Ink) -> Vec<String> {
    let mut faults = Vec::new();
    let count = drawing.strokes.len();
    if ink.lines.len() < count {
        return vec![format!("shows {} of {count} strokes", ink.lines.len())];
    }
    // after the strokes come the lines of fractions and roots: they are letters
    let (strokes, rules) = ink.lines.split_at(count);
    for (stroke, line) in drawing.strokes.iter().zip(strokes) {
        let said = Area::around(points(stroke)).expect("a stroke begins somewhere");
        let seen = Area::around(line.iter().copied()).expect("a line begins somewhere");
        if !(said.grown(EXACT).covers(seen) && seen.grown(EXACT).covers(said)) {
            faults.push(format!("{:?} is at {seen:?}, not at {said:?}", stroke.style));
        }
    }
    let picture = Area { low: drawing.low, high: drawing.high }.grown(EXACT);
    faults.extend(
        strokes.iter().flatten().find(|at| !picture.holds(**at)).map(|at| format!("a stroke leaves it at {at:?}")),
    );
    let rules = rules.iter().filter_map(|line| Area::around(line.iter().copied()));
    let letters: Vec<Area> = ink.letters.iter().copied().chain(rules).collect();
    let written = written(drawing, &letters, &mut faults);
    for (place, (label, box_)) in written.iter().enumerate() {
        if !kept_free(label).grown(FORGIVEN).covers(*box_) {
            faults.push(format!("`{}` fills {box_:?}, more than {:?}", words(label), kept_free(label)));
        }
        if !picture.covers(*box_) {
            faults.push(format!("`{}` leaves the picture", words(label)));
        }
        for (other, _) in written[..place].iter().filter(|(_, other)| other.grown(BETWEEN_LABELS).meets(*box_)) {
            faults.push(format!("`{}` touches `{}`", words(label), words(other)));
        }
        let near = box_.grown(FROM_STROKES);
        for (stroke, line) in drawing.strokes.iter().zip(strokes) {
            if line.iter().any(|at| near.holds(*at)) || (stroke.style == Style::Filled && within(box_.middle(), line)) {
                faults.push(format!("`{}` touches a stroke: {:?}", words(label), stroke.style));
            }
        }
    }
    faults
}

/// The ink of a drawing whose labels fill the boxes that are kept free for them, without a page.
pub fn as_meant(drawing: &Drawing) -> Ink {
    let lines = drawing.strokes.iter().map(points).collect();
    // two boxes may stand as near to each other as labels may
    let letters = drawing.labels.iter().map(|label| kept_free(label).grown(-0.01)).collect();
    Ink { lines, letters }
}

/// The labels and the box that the letters of each really fill.
fn written<'d>(drawing: &'d Drawing, letters: &[Area], faults: &mut Vec<String>) -> Vec<(&'d Label, Area)> {
    let mut boxes: Vec<Option<Area>> = vec![None; drawing.labels.len()];
    for letter in letters {
        let apart = |label: &Label| {
            let (kept, at) = (kept_free(label), letter.middle());
            let [x, y] = [(at.x, kept.low.x, kept.high.x), (at.y, kept.low.y, kept.high.y)]
                .map(|(at, low, high)| (low - at).max(at - high).max(0.0));
            x.hypot(y)
        };
        let nearest = (0..boxes.len()).min_by(|a, b| apart(&drawing.labels[*a]).total_cmp(&apart(&drawing.labels[*b])));
        match nearest.filter(|place| apart(&drawing.labels[*place]) < 2.0 * FORGIVEN) {
            Some(place) => boxes[place] = Some(boxes[place].map_or(*letter, |sofar| sofar.and(*letter))),
            None => faults.push(format!("a letter at {:?} is far from every label", letter.middle())),
        }
    }
    let mut written = Vec::new();
    for (label, box_) in drawing.labels.iter().zip(boxes) {
        match box_ {
            Some(box_) => written.push((label, box_)),
            None => faults.push(format!("`{}` is not written", words(label))),
        }
    }
    written
}

/// The box that a drawing keeps free for a label.
fn kept_free(label: &Label) -> Area {
    let half = Point { x: label.size.x / 2.0, y: label.size.y / 2.0 };
    let low = Point { x: label.centre.x - half.x, y: label.centre.y - half.y };
    let high = Point { x: label.centre.x + half.x, y: label.centre.y + half.y };
    Area { low, high }
}

fn words(label: &Label) -> String {
    print::text_unicode(&label.text)
}

/// Points along a stroke.
fn points(stroke: &Stroke) -> Vec<Point> {
    let mut points = vec![stroke.from];
    for piece in &stroke.pieces {
        let from = points[points.len() - 1];
        match *piece {
            Section::Line(to) => {
                let third = |at: f64| Point { x: from.x + at * (to.x - from.x), y: from.y + at * (to.y - from.y) };
                points.extend(along([from, third(1.0 / 3.0), third(2.0 / 3.0), to]));
            }
            Section::Curve(first, second, to) => points.extend(along([from, first, second, to])),
        }
    }
    points
}

/// Is a place inside a closed line? A ray to the right crosses it an odd number of times.
fn within(at: Point, line: &[Point]) -> bool {
    let pieces = line.iter().zip(line.iter().cycle().skip(1));
    let crossed = pieces.filter(|(from, to)| {
        (from.y > at.y) != (to.y > at.y) && at.x < from.x + (at.y - from.y) / (to.y - from.y) * (to.x - from.x)
    });
    crossed.count() % 2 == 1
}
