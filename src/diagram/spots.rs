//! Places for a label: beside a line, within an arc, around a sphere and inside it.

use super::canvas::Spot;
use super::drawing::Point;

/// Spots on both sides of a line, first on the side to which a direction shows.
pub fn beside(from: Point, to: Point, first: Point) -> Vec<Spot> {
    let across = (to - from).unit().turned();
    let first = if across.dot(first) >= 0.0 { across } else { -across };
    let at = [0.5, 0.65, 0.35, 0.8, 1.0].map(|share| from + (to - from) * share);
    [first, -first].into_iter().flat_map(|side| at.map(|point| Spot::new(point, side))).collect()
}

/// Spots around a sphere.
pub fn around(centre: Point, radius: f64, first: Point, along: Point) -> Vec<Spot> {
    let leaning = [first, -first]
        .into_iter()
        .flat_map(|side| [0.0, 0.5, -0.5, 1.0, -1.0, 2.0].map(|share| (side + along * share).unit()));
    let near = leaning.map(|out| Spot::new(centre + out * radius, out));
    let far = [first, -first].map(|side| Spot::new(centre + side * (radius + 1.3), side));
    near.chain(far).collect()
}

/// Spots within a sphere, clear of its centre, the first between two directions.
pub fn inside(centre: Point, radius: f64, first: Point, second: Point) -> impl Iterator<Item = Spot> {
    let leaning = [0.5, -0.5, 1.0, -1.0, 0.0, 2.0, -2.0];
    let ways = [first, -first].into_iter().flat_map(move |side| leaning.map(|share| (side + second * share).unit()));
    let near = ways.clone().map(move |way| Spot::over(centre + way * (radius * 0.5)));
    let far = ways.map(move |way| Spot::over(centre + way * (radius * 0.58)));
    near.chain(far)
}

/// Spots for an angle: in its arc; beside a narrow one, beyond the line from which it is measured or beyond its arrow.
pub fn in_arc(centre: Point, radius: f64, line: Point, arrow: Point) -> Vec<Spot> {
    let middle = (line + arrow).unit();
    let within = [0.0, 0.5, 1.0, 1.6, 2.2, 2.8].map(|step| Spot::new(centre + middle * (radius + step), middle));
    let off_line = arrow - line * arrow.dot(line);
    let off_arrow = line - arrow * arrow.dot(line);
    let outside = [(line, -off_line), (arrow, -off_arrow)].into_iter().flat_map(|(ray, away)| {
        let near = [0.0, 0.7, -0.5, 1.4].map(|step| Spot::new(centre + ray * (radius + step), away));
        let off = [0.0, 1.2, 2.4].map(|step| Spot::new(centre + ray * (radius + step) + away.unit() * 1.2, away));
        near.into_iter().chain(off)
    });
    // A long one: beyond all else.
    let far = [4.0, 5.4, 6.8].map(|step| Spot::new(centre + middle * (radius + step), middle));
    within.into_iter().chain(outside).chain(far).collect()
}
