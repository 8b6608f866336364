//! Every style of every question, two hundred variants of each: pdflatex sets them all without a complaint.

use carom::bank::Question;

use super::clear::{as_meant, faults as faults_of};
use super::diagrams::of_solution;
use super::engine::{complaints, placed};
use super::papers::{Batch, bank, batch};
use super::{folder, on_both};

/// How many variants of a style are set, where it has so many.
const VARIANTS: usize = 200;

/// A question's variants, set; what is wrong with which.
fn faults(question: &Question) -> (Batch, Vec<String>) {
    let batch = batch(question, VARIANTS);
    let folder = folder(&format!("variants/{}", question.id.replace('/', "-")));
    let found = placed(&batch.paper, &|paper| complaints(&folder, paper));
    let named = |(place, complaint): (Option<usize>, String)| {
        format!("{}: {complaint}", place.map_or(&question.id, |place| &batch.names[place]))
    };
    let faults = found.into_iter().map(named).chain(crowded(&batch).into_iter().take(3)).collect();
    (batch, faults)
}

/// Diagrams in which labels have no room of their own.
fn crowded(batch: &Batch) -> Vec<String> {
    let mut found = Vec::new();
    for (name, question) in batch.names.iter().zip(&batch.paper.questions) {
        for diagram in question.diagrams.iter().chain(of_solution(question)) {
            let faults = faults_of(&diagram.drawing, &as_meant(&diagram.drawing));
            found.extend(faults.first().map(|fault| format!("{name}: {} {fault}", diagram.title)));
        }
    }
    found
}

#[test]
#[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
fn carom_knows_latex_for_two_hundred_variants_of_every_style() {
    let bank = bank();
    let (mut all, mut styles, mut wrong) = (0, 0, Vec::new());
    for (batch, faults) in on_both(&bank.questions, faults) {
        for (style, count, exhausted) in &batch.styles {
            assert!(*count == VARIANTS || *exhausted, "{style} gave {count} variants and has more");
            assert!(*count > 0, "{style} has no variants");
            if *count < VARIANTS {
                println!("{style} has no more than {count} variants");
            }
            all += count;
            styles += 1;
        }
        wrong.extend(faults);
    }
    println!("{all} variants of {styles} styles of {} questions set", bank.questions.len());
    assert!(styles >= 2 * bank.questions.len() && all > 100 * styles, "{all} variants of {styles} styles");
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}
