//! Points and boxes of the plane of a picture. No sines and cosines: sums, products and square roots come out the same
//! on every machine, and so do the pictures.

use std::ops::{Add, Mul, Neg, Sub};

use super::Point;

impl Point {
    /// A point by its coordinates.
    pub fn new(x: f64, y: f64) -> Point {
        Point { x, y }
    }

    /// The scalar product.
    pub fn dot(self, other: Point) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The distance from the origin.
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The same direction with length 1; the origin stays.
    pub fn unit(self) -> Point {
        let length = self.length();
        if length > 0.0 { self * (1.0 / length) } else { self }
    }

    /// Turned by +90 degrees.
    pub fn turned(self) -> Point {
        Point::new(-self.y, self.x)
    }

    /// The mirror image in the x-axis.
    pub fn mirrored(self) -> Point {
        Point::new(self.x, -self.y)
    }
}

impl Add for Point {
    type Output = Point;
    fn add(self, other: Point) -> Point {
        Point::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Point {
    type Output = Point;
    fn sub(self, other: Point) -> Point {
        Point::new(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Point {
    type Output = Point;
    fn mul(self, scale: f64) -> Point {
        Point::new(self.x * scale, self.y * scale)
    }
}

impl Neg for Point {
    type Output = Point;
    fn neg(self) -> Point {
        self * -1.0
    }
}

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The corner at the left and the bottom.
    pub low: Point,
    /// The corner at the right and the top.
    pub high: Point,
}

impl Frame {
    /// The box of a size around its middle.
    pub fn around(centre: Point, size: Point) -> Frame {
        Frame { low: centre - size * 0.5, high: centre + size * 0.5 }
    }

    /// The box with a margin on every side.
    pub fn grown(self, margin: f64) -> Frame {
        let margin = Point::new(margin, margin);
        Frame { low: self.low - margin, high: self.high + margin }
    }

    /// The smallest box that also holds a point.
    pub fn with(self, point: Point) -> Frame {
        Frame {
            low: Point::new(self.low.x.min(point.x), self.low.y.min(point.y)),
            high: Point::new(self.high.x.max(point.x), self.high.y.max(point.y)),
        }
    }

    /// How far the box reaches in a direction, from the origin.
    pub fn farthest(self, direction: Point) -> f64 {
        let side = |low: f64, high: f64, towards: f64| f64::max(low * towards, high * towards);
        side(self.low.x, self.high.x, direction.x) + side(self.low.y, self.high.y, direction.y)
    }

    /// Do two boxes share more than an edge?
    pub fn meets(self, other: Frame) -> bool {
        self.low.x < other.high.x && other.low.x < self.high.x && self.low.y < other.high.y && other.low.y < self.high.y
    }

    /// Does a straight line between two points go through the box?
    pub fn is_crossed(self, from: Point, to: Point) -> bool {
        // The part of the line that lies between both pairs of sides.
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        let step = to - from;
        for (start, along, low, high) in
            [(from.x, step.x, self.low.x, self.high.x), (from.y, step.y, self.low.y, self.high.y)]
        {
            if along == 0.0 {
                if start <= low || start >= high {
                    return false;
                }
                continue;
            }
            let (one, other) = ((low - start) / along, (high - start) / along);
            enters = enters.max(one.min(other));
            leaves = leaves.min(one.max(other));
        }
        enters < leaves
    }

    /// Does a circle go through the box?
    pub fn is_crossed_by_circle(self, centre: Point, radius: f64) -> bool {
        let nearest = Point::new(centre.x.clamp(self.low.x, self.high.x), centre.y.clamp(self.low.y, self.high.y));
        let far = |middle: f64, low: f64, high: f64| if middle - low > high - middle { low } else { high };
        let farthest = Point::new(far(centre.x, self.low.x, self.high.x), far(centre.y, self.low.y, self.high.y));
        (nearest - centre).length() < radius && (farthest - centre).length() > radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_is_crossed_by_what_goes_through_it_and_not_by_what_touches_it() {
        let unit = Frame { low: Point::new(0.0, 0.0), high: Point::new(1.0, 1.0) };
        let lines = [
            ((-1.0, 0.5), (2.0, 0.5), true),
            ((-1.0, 0.0), (2.0, 0.0), false),
            ((-1.0, 1.5), (0.4, 1.1), false),
            ((-0.5, 0.5), (0.5, 1.5), false),
            ((-0.4, 0.5), (0.6, 1.5), true),
            ((0.4, 0.4), (0.6, 0.6), true),
            ((2.0, -1.0), (2.0, 3.0), false),
        ];
        for ((x, y), (p, q), crossed) in lines {
            assert_eq!(unit.is_crossed(Point::new(x, y), Point::new(p, q)), crossed, "{x} {y} to {p} {q}");
        }
        let circles =
            [((0.5, 0.5), 0.4, true), ((0.5, 0.5), 0.8, false), ((2.0, 0.5), 1.1, true), ((2.0, 0.5), 0.9, false)];
        for ((x, y), radius, crossed) in circles {
            assert_eq!(unit.is_crossed_by_circle(Point::new(x, y), radius), crossed, "{x} {y} {radius}");
        }
    }
}
