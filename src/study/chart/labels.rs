//! Labels beside marks: each goes to the first spot where it covers nothing, with a thin line to its mark if that is far.

use std::cmp::Ordering;

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

/// Places labels inside a frame; returns how many found no free spot and were left out.
///
/// What comes first has the choice, so several orders are tried, and the one with the shortest lines is drawn.
pub fn place(canvas: &mut Canvas, frame: Area, size: f64, labels: &[Label]) -> usize {
    let crowd = |label: &Label| {
        let close = |other: &&Label| (other.mark.0 - label.mark.0).hypot(other.mark.1 - label.mark.1) < 90.0;
        labels.iter().filter(close).count()
    };
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|place| std::cmp::Reverse((crowd(&labels[*place]), labels[*place].lines.len())));
    let turned = (0..labels.len().min(ORDERS)).map(|turn| {
        let mut order = order.clone();
        order.rotate_left(turn);
        order
    });
    let backwards = order.iter().rev().copied().collect();
    let found = turned.chain([backwards]).map(|order| Placing::of(canvas, frame, size, labels, &order));
    let best = found.min_by(|one, other| one.merit().partial_cmp(&other.merit()).unwrap_or(Ordering::Equal));
    let Some(mut best) = best else { return 0 };
    for _ in 0..ROUNDS {
        best.improve(canvas, frame, size, labels);
    }
    for spot in &best.spots {
        if let Some(leader) = &spot.leader {
            canvas.line(leader.from, leader.to, Tone::Faint, 0.6, "");
        }
        let area = spot.area;
        let mut foot = area.top + GAP + size * 0.9;
        for line in &labels[spot.label].lines {
            canvas.text(((area.left + area.right) / 2.0, foot), Anchor::Middle, size, Tone::Ink, line);
            foot += size * LINE;
        }
    }
    labels.len() - best.spots.len()
}

/// How many orders are tried.
const ORDERS: usize = 24;

/// How often every label may look for a better spot than the one it got.
const ROUNDS: usize = 3;

/// Where a label stands.
struct Spot {
    label: usize,
    area: Area,
    leader: Option<Leader>,
    cost: f64,
}

/// What came of an order.
struct Placing {
    spots: Vec<Spot>,
}

impl Placing {
    fn of(canvas: &Canvas, frame: Area, size: f64, labels: &[Label], order: &[usize]) -> Placing {
        let mut placing = Placing { spots: Vec::new() };
        let mut room = Room::of(canvas);
        for label in order {
            if let Some(spot) = room.best(frame, size, labels, *label) {
                room.take(&spot);
                placing.spots.push(spot);
            }
        }
        placing
    }

    /// Many labels are better than few, and short lines than long ones.
    fn merit(&self) -> (usize, f64) {
        (usize::MAX - self.spots.len(), self.spots.iter().map(|spot| spot.cost).sum())
    }

    /// Lets each label look again, now that the others have their spots.
    fn improve(&mut self, canvas: &Canvas, frame: Area, size: f64, labels: &[Label]) {
        for place in 0..self.spots.len() {
            let mut room = Room::of(canvas);
            let others = self.spots.iter().enumerate().filter(|(other, _)| *other != place);
            others.for_each(|(_, spot)| room.take(spot));
            if let Some(spot) = room.best(frame, size, labels, self.spots[place].label)
                && spot.cost < self.spots[place].cost
            {
                self.spots[place] = spot;
            }
        }
    }
}

/// What the line to a label may cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Crossing {
    Nothing,
    Lines,
    Marks,
}

/// What is free while labels are placed.
struct Room<'c> {
    taken: Vec<Area>,
    written: Vec<Area>,
    marked: &'c [Area],
}

impl Room<'_> {
    fn of(canvas: &Canvas) -> Room<'_> {
        Room { taken: canvas.taken.clone(), written: canvas.written.clone(), marked: &canvas.marked }
    }

    fn take(&mut self, spot: &Spot) {
        self.taken.push(spot.area);
        self.written.push(spot.area);
        if let Some(leader) = &spot.leader {
            self.taken.extend(leader.steps().map(|(x, y)| Area::around(x, y, 1.0)));
        }
    }

    /// The best free spot for a label. Where marks crowd, its line may cross another, and at last run over a mark; over
    /// words it never does.
    fn best(&self, frame: Area, size: f64, labels: &[Label], label: usize) -> Option<Spot> {
        let ways = [(Crossing::Nothing, 0.0), (Crossing::Lines, 2000.0), (Crossing::Marks, 8000.0)];
        let found = ways.into_iter().filter_map(|(crossing, dear)| {
            let (area, leader, away) = self.spot(frame, size, &labels[label], crossing)?;
            Some(Spot { label, area, leader, cost: away * away + dear })
        });
        found.min_by(|one, other| one.cost.total_cmp(&other.cost))
    }

    /// The first free spot for a label, with the line to it if it is far, and how far it is.
    fn spot(&self, frame: Area, size: f64, label: &Label, crossing: Crossing) -> Option<(Area, Option<Leader>, f64)> {
        let (x, y) = label.mark;
        let width = label.lines.iter().map(|line| Canvas::width_of(line, size)).fold(0.0, f64::max);
        let extra = (label.lines.len() - 1) as f64 * size * LINE;
        let half = (width / 2.0 + GAP, size * 0.55 + extra / 2.0 + GAP);
        for (dx, dy, away) in spots(half) {
            let (x, y) = (x + dx, y + dy);
            let area = Area { left: x - half.0, right: x + half.0, top: y - half.1, bottom: y + half.1 };
            if !area.lies_in(&frame) || self.taken.iter().any(|taken| area.meets(taken)) {
                continue;
            }
            let leader = Leader { from: label.mark, to: nearest(&area, label.mark) };
            let far = away > NEAR;
            if far && leader.crosses(self, crossing) {
                continue;
            }
            return Some((area, far.then_some(leader), away));
        }
        None
    }
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
    fn crosses(&self, room: &Room, crossing: Crossing) -> bool {
        let own = Area::around(self.from.0, self.from.1, 9.0);
        let forbidden = |point: &Area| match crossing {
            Crossing::Nothing => room.taken.iter().any(|taken| point.meets(taken)),
            Crossing::Lines => room.written.iter().chain(room.marked).any(|taken| point.meets(taken)),
            Crossing::Marks => room.written.iter().any(|taken| point.meets(taken)),
        };
        self.steps().map(|(x, y)| Area::around(x, y, 0.5)).any(|point| !point.meets(&own) && forbidden(&point))
    }
}
