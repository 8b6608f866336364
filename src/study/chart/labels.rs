//! Labels beside marks: each goes to the first spot where it covers nothing, with a thin line to its mark if that is far.

use super::canvas::{Anchor, Area, Canvas, Tone};

/// Space left around a label.
const GAP: f64 = 2.0;

/// From line to line of a label, in sizes of its letters.
const LINE: f64 = 1.2;

/// A label to be placed: a line of words for each of the marks that stand together.
pub struct Label {
    /// The middle of its mark, or of the first of several.
    pub mark: (f64, f64),
    pub lines: Vec<String>,
}

/// How near marks are to share a label.
const TOGETHER: f64 = 9.0;

/// Labels for marks with their names; those that cannot be told apart by a line to them share one.
pub fn together(marks: impl Iterator<Item = ((f64, f64), String)>) -> Vec<Label> {
    let mut marks: Vec<((f64, f64), String)> = marks.collect();
    marks.sort_by(|one, other| one.0.0.total_cmp(&other.0.0));
    let mut labels: Vec<Label> = Vec::new();
    for (mark, name) in marks {
        let near = |label: &&mut Label| (label.mark.0 - mark.0).hypot(label.mark.1 - mark.1) < TOGETHER;
        match labels.iter_mut().find(near) {
            Some(label) => label.lines.push(name),
            None => labels.push(Label { mark, lines: vec![name] }),
        }
    }
    labels
}

/// Places labels inside a frame, those in the thick of it first; returns how many found no free spot and were left out.
pub fn place(canvas: &mut Canvas, frame: Area, size: f64, labels: &[Label]) -> usize {
    let near = |label: &Label| {
        let close = |other: &&Label| (other.mark.0 - label.mark.0).hypot(other.mark.1 - label.mark.1) < 90.0;
        labels.iter().filter(close).count()
    };
    let mut order: Vec<&Label> = labels.iter().collect();
    order.sort_by_key(|label| std::cmp::Reverse((near(label), label.lines.len())));
    // Where marks crowd, a thin line may cross another, and at last run over a mark; over words it never does.
    let placed = |label: &&Label, canvas: &mut Canvas| {
        [Crossing::Nothing, Crossing::Lines, Crossing::Marks]
            .into_iter()
            .any(|crossing| place_one(canvas, frame, size, label, crossing))
    };
    order.into_iter().filter(|label| !placed(label, canvas)).count()
}

/// What the line to a label may cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Crossing {
    Nothing,
    Lines,
    Marks,
}

fn place_one(canvas: &mut Canvas, frame: Area, size: f64, label: &Label, crossing: Crossing) -> bool {
    let (x, y) = label.mark;
    let width = label.lines.iter().map(|line| Canvas::width_of(line, size)).fold(0.0, f64::max);
    let extra = (label.lines.len() - 1) as f64 * size * LINE;
    let half = (width / 2.0 + GAP, size * 0.55 + extra / 2.0 + GAP);
    for (dx, dy, away) in spots(half) {
        let middle = (x + dx, y + dy);
        let area = Area {
            left: middle.0 - half.0,
            right: middle.0 + half.0,
            top: middle.1 - half.1,
            bottom: middle.1 + half.1,
        };
        if !area.lies_in(&frame) || canvas.taken.iter().any(|taken| area.meets(taken)) {
            continue;
        }
        let far = away > NEAR;
        let leader = Leader { from: label.mark, to: nearest(&area, label.mark) };
        if far && leader.crosses(canvas, crossing) {
            continue;
        }
        canvas.take(area);
        canvas.written.push(area);
        if far {
            canvas.line(leader.from, leader.to, Tone::Faint, 0.6, "");
            leader.steps().for_each(|(x, y)| canvas.take(Area::around(x, y, 1.0)));
        }
        let mut foot = middle.1 - extra / 2.0 + size * 0.35;
        for line in &label.lines {
            canvas.text((middle.0, foot), Anchor::Middle, size, Tone::Ink, line);
            foot += size * LINE;
        }
        return true;
    }
    false
}

/// A label that is nearer than this needs no line to its mark.
const NEAR: f64 = 13.0;

/// Where the middle of a label of this half size may go, seen from its mark, and how far its edge is then; nearest first.
fn spots(half: (f64, f64)) -> Vec<(f64, f64, f64)> {
    let mut spots = Vec::new();
    for row in -28..=28 {
        for column in -30..=30 {
            let (dx, dy) = (f64::from(column) * 9.0, f64::from(row) * 9.0);
            let away = (dx.abs() - half.0).max(0.0).hypot((dy.abs() - half.1).max(0.0));
            if away >= 6.0 {
                spots.push((dx, dy, away));
            }
        }
    }
    // Beside a mark is better than above it, and what is straight above better than what is askew.
    let cost = |(dx, dy, away): &(f64, f64, f64)| away + 0.1 * dx.abs().min(dy.abs()) + 0.02 * dy.abs();
    spots.sort_by(|one, other| cost(one).total_cmp(&cost(other)));
    spots
}

/// The point of an area that is nearest to another.
fn nearest(area: &Area, (x, y): (f64, f64)) -> (f64, f64) {
    (x.clamp(area.left + GAP, area.right - GAP), y.clamp(area.top + GAP, area.bottom - GAP))
}

struct Leader {
    from: (f64, f64),
    to: (f64, f64),
}

impl Leader {
    fn steps(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let ((x, y), (p, q)) = (self.from, self.to);
        let count = ((p - x).hypot(q - y) / 3.0).ceil().max(1.0) as u32;
        (0..=count).map(move |step| {
            let part = f64::from(step) / f64::from(count);
            (x + part * (p - x), y + part * (q - y))
        })
    }

    /// Does it run over something that it may not, away from its own mark?
    fn crosses(&self, canvas: &Canvas, crossing: Crossing) -> bool {
        let own = Area::around(self.from.0, self.from.1, 9.0);
        let forbidden = |point: &Area| match crossing {
            Crossing::Nothing => canvas.taken.iter().any(|taken| point.meets(taken)),
            Crossing::Lines => canvas.written.iter().chain(&canvas.marked).any(|taken| point.meets(taken)),
            Crossing::Marks => canvas.written.iter().any(|taken| point.meets(taken)),
        };
        self.steps().map(|(x, y)| Area::around(x, y, 0.5)).any(|point| !point.meets(&own) && forbidden(&point))
    }
}
