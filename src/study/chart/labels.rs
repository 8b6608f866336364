//! Labels beside marks: each goes to the first spot where it covers nothing, with a thin line to its mark if that is far.

use super::canvas::{Anchor, Area, Canvas, Tone};

/// Space left around a label.
const GAP: f64 = 2.0;

/// A label to be placed.
pub struct Label<'l> {
    /// The middle of its mark.
    pub mark: (f64, f64),
    pub text: &'l str,
    pub tone: Tone,
}

/// Places labels inside a frame, those in the thick of it first; returns how many found no free spot and were left out.
pub fn place(canvas: &mut Canvas, frame: Area, size: f64, labels: &[Label]) -> usize {
    let near = |label: &Label| {
        let close = |other: &&Label| (other.mark.0 - label.mark.0).hypot(other.mark.1 - label.mark.1) < 90.0;
        labels.iter().filter(close).count()
    };
    let mut order: Vec<&Label> = labels.iter().collect();
    order.sort_by_key(|label| std::cmp::Reverse(near(label)));
    // Where marks crowd, a thin line may run over one; over words it never does.
    let placed = |label: &&Label, canvas: &mut Canvas| {
        [true, false].into_iter().any(|strict| place_one(canvas, frame, size, label, strict))
    };
    order.into_iter().filter(|label| !placed(label, canvas)).count()
}

fn place_one(canvas: &mut Canvas, frame: Area, size: f64, label: &Label, strict: bool) -> bool {
    let (x, y) = label.mark;
    let width = Canvas::width_of(label.text, size);
    for (dx, dy) in spots() {
        let middle = (x + dx + if dx == 0.0 { 0.0 } else { dx.signum() * width / 2.0 }, y + dy);
        let area = Area {
            left: middle.0 - width / 2.0 - GAP,
            right: middle.0 + width / 2.0 + GAP,
            top: middle.1 - size * 0.55 - GAP,
            bottom: middle.1 + size * 0.55 + GAP,
        };
        if !area.lies_in(&frame) || canvas.taken.iter().any(|taken| area.meets(taken)) {
            continue;
        }
        let far = dx.abs().max(dy.abs()) > 18.0;
        let leader = Leader { from: label.mark, to: nearest(&area, label.mark) };
        if far && leader.crosses(if strict { &canvas.taken } else { &canvas.written }, label.mark) {
            continue;
        }
        canvas.take(area);
        canvas.written.push(area);
        if far {
            canvas.line(leader.from, leader.to, Tone::Faint, 0.6, "");
            leader.steps().for_each(|(x, y)| canvas.take(Area::around(x, y, 1.0)));
        }
        canvas.text((middle.0, middle.1 + size * 0.35), Anchor::Middle, size, label.tone, label.text);
        return true;
    }
    false
}

/// Where a label may go, as the distance of its nearer edge from the mark, nearest first.
fn spots() -> impl Iterator<Item = (f64, f64)> {
    let close =
        [(9.0, 0.0), (-9.0, 0.0), (0.0, -14.0), (0.0, 14.0), (6.0, -12.0), (6.0, 12.0), (-6.0, -12.0), (-6.0, 12.0)];
    let rings = (1..=14).flat_map(|ring| {
        let r = 14.0 + 12.0 * f64::from(ring);
        let sides =
            [(0.0, -1.0), (0.0, 1.0), (0.5, -1.0), (0.5, 1.0), (-0.5, -1.0), (-0.5, 1.0), (1.0, -0.5), (1.0, 0.5)];
        let more =
            [(-1.0, -0.5), (-1.0, 0.5), (1.0, 0.0), (-1.0, 0.0), (1.0, -1.0), (1.0, 1.0), (-1.0, -1.0), (-1.0, 1.0)];
        sides.into_iter().chain(more).map(move |(x, y)| (x * r, y * r))
    });
    close.into_iter().chain(rings)
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

    /// Does it run over something other than its own mark?
    fn crosses(&self, taken: &[Area], mark: (f64, f64)) -> bool {
        let own = Area::around(mark.0, mark.1, 9.0);
        self.steps().any(|(x, y)| {
            let point = Area::around(x, y, 0.5);
            !point.meets(&own) && taken.iter().any(|taken| point.meets(taken))
        })
    }
}
