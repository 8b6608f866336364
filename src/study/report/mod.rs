//! A study as files: charts, tables, one page for a teacher and the same page for the documentation.

mod page;
mod tables;

use super::chart::{Bar, Bars, Chart, Series, Work, bars, scatter, strips};
use super::claim::Claims;
use super::exam_grid::Census;
use super::map::Map;
use super::tolerance::Spread;
use super::work::{Cost, KINDS};
use crate::render::RenderedFile;

/// Everything that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// Maps of quantities by arrangement.
    pub quantities: Vec<Map>,
    /// Maps of velocities by method.
    pub velocities: Vec<Map>,
    /// The tables of claims.
    pub claims: Claims,
    /// What of the claims does not hold.
    pub broken: Vec<String>,
    /// The exam grid.
    pub census: Census,
    /// Rounding on the way.
    pub spreads: Vec<Spread>,
    /// Times, of other programs too.
    pub costs: Vec<Cost>,
}

impl Study {
    /// All files, under names that begin with `methods`; the reason if a template of ours is wrong.
    pub fn files(&self) -> Result<Vec<RenderedFile>, String> {
        let charts = self.charts()?;
        let mut files = vec![page::html(self, &charts)?, page::markdown(self)?];
        let file = |name: String, contents| RenderedFile { name: format!("methods/{name}"), contents };
        files.extend(tables::all(self).into_iter().map(|(name, text)| file(name.to_owned(), text)));
        files.extend(charts.into_iter().map(|chart| file(format!("{}.svg", chart.name), chart.svg)));
        Ok(files)
    }

    /// Every chart; an error if a label found no room, since a chart must not keep silent about a method.
    fn charts(&self) -> Result<Vec<Chart>, String> {
        let (work, missing) = scatter(
            &self.series(),
            "Cost of one impact across, worst error up, both by powers of ten, a mark for each method",
        );
        if missing > 0 {
            return Err(format!("{missing} labels of the chart of cost and error find no room"));
        }
        let chart = |name: &str, svg| Chart { name: name.to_owned(), svg };
        Ok(vec![
            chart("work-precision", work),
            chart("tiers", self.tiers()),
            chart(
                "stability-quantities",
                strips(&self.quantities, "How many figures of a quantity are right, by arrangement and by k"),
            ),
            chart(
                "stability-velocities",
                strips(&self.velocities, "How many figures of the velocities are right, by method and by k"),
            ),
            chart("tolerance", self.tolerance()),
        ])
    }

    /// Points of the chart of cost and error: each method where it solves any line of centres in fractions, or, if it
    /// solves only other scenes, where it is cheapest.
    fn series(&self) -> Vec<Series> {
        let mut series: Vec<Series> = Vec::new();
        for cost in self.charted() {
            let Some(error) = cost.error.or_else(|| (cost.work == Work::Exact).then_some(0.0)) else { continue };
            let point = (cost.nanoseconds, error);
            match series.iter_mut().find(|one| one.name == cost.name) {
                Some(one) if cost.steps.is_some() => one.points.push(point),
                Some(one) if one.points[0].0 > point.0 => one.points = vec![point],
                Some(_) => {}
                None => series.push(Series { name: cost.name.clone(), work: cost.work, points: vec![point] }),
            }
        }
        series
    }

    /// What the chart of cost and error is about.
    fn charted(&self) -> impl Iterator<Item = &Cost> {
        self.costs.iter().filter(|cost| cost.scene == "oblique" || !self.is_oblique(&cost.name))
    }

    fn is_oblique(&self, name: &str) -> bool {
        self.costs.iter().any(|cost| cost.name == name && cost.scene == "oblique")
    }

    /// For each kind of scene the cheapest exact method, and the plain formula beside it.
    fn tiers(&self) -> String {
        let row = |scene: &str, words: &str, work: Work, mark: usize| {
            let cheapest = self
                .costs
                .iter()
                .filter(|cost| cost.scene == scene && cost.work == work)
                .min_by(|one, other| one.nanoseconds.total_cmp(&other.nanoseconds))?;
            let mut values = vec![0.0; 2];
            values[mark] = cheapest.nanoseconds;
            let name = if mark == 0 || work == Work::Exact && scene == "letters" { words } else { "" };
            let says = format!("{}, {} ns", cheapest.name, short(cheapest.nanoseconds));
            Some(Bar { name: name.to_owned(), says, values })
        };
        let rows: Vec<Bar> = KINDS
            .iter()
            .flat_map(|kind| [row(kind.name, kind.words, Work::Double, 0), row(kind.name, kind.words, Work::Exact, 1)])
            .flatten()
            .collect();
        let chart = Bars {
            scale: "cost of one impact in nanoseconds, by the cheapest method of its kind",
            marks: &["in doubles", "exactly"],
            bars: true,
            words: "The cost of an impact by the numbers that the scene needs",
        };
        bars(chart, &rows)
    }

    fn tolerance(&self) -> String {
        let row = |spread: &Spread| Bar {
            name: format!("{}, {} figures kept", spread.quantity, spread.figures),
            says: format!("±1 unit: {:.0}%", 100.0 * spread.within_a_unit as f64 / spread.scenes as f64),
            values: spread.tolerance.iter().map(|part| 100.0 * part).collect(),
        };
        let chart = Bars {
            scale: "honest tolerance in per cent of the answer",
            bars: false,
            marks: &["half of the scenes need less", "95 in 100 need less", "the most that any needs"],
            words: "How wide a tolerance must be so that no honest working is marked wrong, by quantity",
        };
        bars(chart, &self.spreads.iter().map(row).collect::<Vec<_>>())
    }
}

/// Two or three figures, as one says a time.
pub(super) fn short(value: f64) -> String {
    if value < 10.0 {
        format!("{value:.1}")
    } else if value < 10_000.0 {
        format!("{value:.0}")
    } else {
        format!("{value:.1e}")
    }
}
