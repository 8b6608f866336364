//! The drawing model: strokes and labels at places that are settled, printed by whoever can.
//!
//! Lengths are in ems of the labels, so that a picture grows with the letters of its page. x points to the right and y
//! up the page.

use crate::expr::Text;

/// A place, or a step from one place to another.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Up the page.
    pub y: f64,
}

/// How a stroke is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// The rim of a sphere.
    Rim,
    /// The line of centres: dashes and dots.
    Centres,
    /// A velocity: a strong line.
    Velocity,
    /// The arc of an angle, an axis or a dimension: a thin line.
    Thin,
    /// What is only imagined: a thin dashed line.
    Dashed,
    /// An area filled with ink: an arrowhead or the point of a centre.
    Filled,
}

/// A line: straight pieces and cubic curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// How it is drawn.
    pub style: Style,
    /// Where it begins.
    pub from: Point,
    /// Where it goes on.
    pub pieces: Vec<Section>,
}

/// A piece of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Section {
    /// Straight to a place.
    Line(Point),
    /// A cubic curve: its two handles and its end.
    Curve(Point, Point, Point),
}

/// Words or a formula in a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What stands there.
    pub text: Text,
    /// The middle of its box.
    pub centre: Point,
    /// Width and height of the box that is kept free for it.
    pub size: Point,
}

/// A picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// What is drawn.
    pub strokes: Vec<Stroke>,
    /// What is written.
    pub labels: Vec<Label>,
    /// The corner at the left and the bottom of all that is in it.
    pub low: Point,
    /// The corner at the right and the top.
    pub high: Point,
}
