//! A drawing in the making: strokes first, then labels, each where it covers nothing.

use super::drawing::{Drawing, Label, Point, Section, Stroke, Style};
use super::geometry::Frame;
use crate::expr::{Text, print};

/// Between a label and what stands beside it.
const CLEARANCE: f64 = 0.12;
/// Length and half the width of an arrowhead.
pub const HEAD: (f64, f64) = (0.72, 0.24);
/// Length of the head of a hollow arrow, half its width, and half the width of the shaft.
const HOLLOW: (f64, f64, f64) = (0.9, 0.46, 0.2);
/// The handle of a quarter of a circle of radius 1.
const QUARTER: f64 = 0.552_285;

/// What a label must not cover.
enum Obstacle {
    Line(Point, Point),
    Circle(Point, f64),
}

/// Where a label may stand: beside a point, on the side to which a direction shows.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// The point.
    pub beside: Point,
    /// The direction, of length 1; nought puts the label over the point.
    pub towards: Point,
}

impl Spot {
    /// Over a point.
    pub fn over(point: Point) -> Spot {
        Spot { beside: point, towards: Point::default() }
    }

    /// Beside a point, towards a direction.
    pub fn new(beside: Point, towards: Point) -> Spot {
        Spot { beside, towards: towards.unit() }
    }

    /// Where the middle of a box can be: with the point at its edge or near that, or with all of it beyond the point.
    fn centres(self, size: Point) -> [Point; 3] {
        let gap = CLEARANCE * 1.8;
        let half = [self.towards.x * size.x / 2.0, self.towards.y * size.y / 2.0].map(f64::abs);
        // The gap is between the point and the side of the box that faces it, however the direction slants.
        let [out_x, out_y] = [(size.x, self.towards.x), (size.y, self.towards.y)]
            .map(|(size, towards)| if towards == 0.0 { f64::INFINITY } else { (size / 2.0 + gap) / towards.abs() });
        let edge = out_x.min(out_y);
        let edge = if edge.is_finite() { edge } else { 0.0 };
        let beyond = half[0] + half[1] + gap;
        [edge, beyond.min(edge + HEAD.1), beyond].map(|reach| self.beside + self.towards * reach)
    }
}

/// A drawing in the making.
#[derive(Default)]
pub struct Canvas {
    drawing: Drawing,
    obstacles: Vec<Obstacle>,
    frame: Option<Frame>,
}

impl Canvas {
    /// The box of all that has been drawn.
    pub fn frame(&self) -> Frame {
        self.frame.unwrap_or(Frame { low: Point::default(), high: Point::default() })
    }

    fn reach(&mut self, point: Point) {
        self.frame = Some(match self.frame {
            Some(frame) => frame.with(point),
            None => Frame { low: point, high: point },
        });
    }

    fn stroke(&mut self, style: Style, from: Point, pieces: Vec<Section>) {
        self.reach(from);
        for piece in &pieces {
            let (Section::Line(end) | Section::Curve(_, _, end)) = *piece;
            self.reach(end);
        }
        self.drawing.strokes.push(Stroke { style, from, pieces });
    }

    /// A straight line.
    pub fn line(&mut self, style: Style, from: Point, to: Point) {
        self.obstacles.push(Obstacle::Line(from, to));
        self.stroke(style, from, vec![Section::Line(to)]);
    }

    /// A line that ends in an arrowhead.
    pub fn arrow(&mut self, style: Style, from: Point, to: Point) {
        let along = (to - from).unit();
        self.line(style, from, to - along * (HEAD.0 * 0.8));
        self.obstacles.push(Obstacle::Line(from, to));
        let (base, side) = (to - along * HEAD.0, along.turned() * HEAD.1);
        for wing in [base + side, base - side] {
            self.obstacles.push(Obstacle::Line(wing, to));
        }
        let notch = to - along * (HEAD.0 * 0.75);
        let pieces = [base + side, notch, base - side, to].map(Section::Line).to_vec();
        self.stroke(Style::Filled, to, pieces);
    }

    /// An arrow of another kind: its outline.
    pub fn hollow_arrow(&mut self, from: Point, to: Point) {
        let along = (to - from).unit();
        let side = along.turned();
        let (length, wide, narrow) = HOLLOW;
        let neck = to - along * length;
        let outline = [
            from + side * narrow,
            neck + side * narrow,
            neck + side * wide,
            to,
            neck - side * wide,
            neck - side * narrow,
            from - side * narrow,
        ];
        let corners: Vec<Point> = outline.into_iter().chain([outline[0]]).collect();
        for pair in corners.windows(2) {
            self.obstacles.push(Obstacle::Line(pair[0], pair[1]));
        }
        self.stroke(Style::Thin, corners[0], corners[1..].iter().copied().map(Section::Line).collect());
    }

    /// A whole circle.
    pub fn circle(&mut self, style: Style, centre: Point, radius: f64) {
        self.obstacles.push(Obstacle::Circle(centre, radius));
        let mut pieces = Vec::with_capacity(4);
        let mut out = Point::new(1.0, 0.0);
        for _ in 0..4 {
            let next = out.turned();
            let handles = [out + next * QUARTER, next + out * QUARTER].map(|handle| centre + handle * radius);
            pieces.push(Section::Curve(handles[0], handles[1], centre + next * radius));
            out = next;
        }
        let corner = Point::new(radius, radius);
        self.reach(centre - corner);
        self.reach(centre + corner);
        self.stroke(style, centre + out * radius, pieces);
    }

    /// A point of ink.
    pub fn dot(&mut self, centre: Point) {
        self.circle(Style::Filled, centre, 0.1);
    }

    /// The arc about a centre from one direction to another, less than a straight angle away; returns its middle direction.
    pub fn arc(&mut self, centre: Point, radius: f64, from: Point, to: Point) -> Point {
        let half = ((1.0 - from.dot(to)) / (1.0 + from.dot(to))).max(0.0).sqrt();
        let quarter = if half > 0.0 { ((1.0 + half * half).sqrt() - 1.0) / half } else { 0.0 };
        let handle = 4.0 / 3.0 * quarter;
        let anticlockwise = from.turned().dot(to) > 0.0;
        let onwards = |direction: Point| if anticlockwise { direction.turned() } else { -direction.turned() };
        let at = |direction: Point| centre + direction * radius;
        let middle = (from + to).unit();
        // Chords short enough that the arc bulges no further than a label stays away.
        let mut chords = vec![(from, middle), (middle, to)];
        for _ in 0..2 {
            let halves = |(one, other): (Point, Point)| {
                let between = (one + other).unit();
                [(one, between), (between, other)]
            };
            chords = chords.into_iter().flat_map(halves).collect();
        }
        self.obstacles.extend(chords.into_iter().map(|(one, other)| Obstacle::Line(at(one), at(other))));
        let curve = Section::Curve(at(from + onwards(from) * handle), at(to - onwards(to) * handle), at(to));
        self.reach(at(middle));
        self.stroke(Style::Thin, at(from), vec![curve]);
        middle
    }

    /// Writes a label at the first spot where it covers nothing; if there is none, where it covers least.
    pub fn label(&mut self, text: Text, spots: impl IntoIterator<Item = Spot>) {
        let (width, height) = print::extent(&text);
        let size = Point::new(width, height);
        let mut best: Option<(usize, Point)> = None;
        for centre in spots.into_iter().flat_map(|spot| spot.centres(size)) {
            let covered = self.covered(Frame::around(centre, size).grown(CLEARANCE));
            if best.is_none_or(|(least, _)| covered < least) {
                best = Some((covered, centre));
            }
            if covered == 0 {
                break;
            }
        }
        let Some((_, centre)) = best else { return };
        let frame = Frame::around(centre, size);
        self.reach(frame.low);
        self.reach(frame.high);
        self.drawing.labels.push(Label { text, centre, size });
    }

    /// How much lies in a box: lines, circles and labels.
    fn covered(&self, frame: Frame) -> usize {
        let strokes = self.obstacles.iter().filter(|obstacle| match obstacle {
            Obstacle::Line(from, to) => frame.is_crossed(*from, *to),
            Obstacle::Circle(centre, radius) => frame.is_crossed_by_circle(*centre, *radius),
        });
        let labels = self.drawing.labels.iter().filter(|label| frame.meets(Frame::around(label.centre, label.size)));
        strokes.count() + labels.count()
    }

    /// The finished drawing, with a margin around it.
    pub fn finish(self) -> Drawing {
        let Frame { low, high } = self.frame().grown(0.3);
        Drawing { low, high, ..self.drawing }
    }
}
