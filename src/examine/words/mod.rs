//! What the words of a question say, beside its scene, its answers and its numbers.
//!
//! Some things are seen in the words as the author wrote them ([`of_question`]), some in those of each variant
//! ([`of_variant`]), and whether the scene contradicts them only where it has numbers ([`contradicted`]).

mod agreement;
mod asked;
mod asked_count;
mod asked_energy;
mod asked_for;
mod asked_things;
mod asked_units;
mod asked_when;
mod asked_where;
mod asked_whose;
mod below_nought;
mod called;
mod compared;
mod exact_form;
mod figures;
mod given;
mod grammar;
mod impacts;
mod in_turn;
mod letters;
mod letters_introduced;
mod lines;
mod marked_laws;
mod marked_lines;
mod marked_values;
mod measured;
mod misspelt;
mod modelled;
mod nouns;
mod own_words;
mod phrases;
mod requests;
mod said;
mod said_of_angles;
mod said_of_components;
mod said_of_conditions;
mod said_of_constants;
mod said_of_limits;
mod said_of_lines;
mod said_of_motion;
mod said_of_order;
mod said_of_paths;
mod said_of_rest;
mod said_of_restitution;
mod said_of_results;
mod said_of_shares;
mod said_of_spheres;
mod said_of_strikes;
mod said_of_titles;
mod said_of_turning;
mod said_of_walls;
#[cfg(test)]
mod said_tests;
mod sentence;
mod sentences;
mod spoken_of;
mod truth;
mod typed;
mod units;
mod units_alike;
mod untold;
mod untold_ways;
mod verbs;

pub use asked_things::unit_asked;
pub use own_words::Heard;
pub use said::contradicted;
pub(in crate::examine) use sentence::in_order;

use super::finding::Finding;
use super::remark::Remark;
use crate::bank::Question;
use crate::generate::Variant;
use crate::paper::Words;

/// What is wrong with the words whatever the numbers are: what they give, and what they ask for.
pub fn of_question(question: &Question) -> Vec<Finding> {
    let checks = [
        given::unsaid,
        letters::of_other_angles,
        letters_introduced::never,
        typed::beside_the_scene,
        untold::conditions,
        untold::elasticity,
        untold::turned_back,
        untold::unit_vectors,
        untold::lines_of_angles,
        untold_ways::ways,
        untold_ways::coefficients,
        untold_ways::in_radians,
        units::astray,
        units_alike::mixed,
        called::otherwise,
        exact_form::unkept,
        figures::otherwise,
        asked::beside_the_point,
        asked_for::others,
        asked_things::unfound,
        asked_when::otherwise,
        asked_when::marked_otherwise,
        asked_where::otherwise,
        asked_whose::otherwise,
        asked_whose::marked_otherwise,
        lines::from_another_line,
        marked_lines::of_another_line,
        marked_laws::of_another_law,
        marked_values::of_another_value,
        misspelt::in_the_title,
        modelled::unsaid,
    ];
    checks.into_iter().flat_map(|check| check(question)).collect()
}

/// What is wrong with the words of a variant: what reads badly, is not true of its numbers, or is not asked.
pub fn of_variant(question: &Question, variant: &Variant, words: &Words, heard: &mut Heard, remarks: &mut Vec<Remark>) {
    sentences::unreadable(words, variant, heard, remarks);
    truth::untrue(heard.claims(words), words, variant, remarks);
    exact_form::unasked(question, variant, &|| heard.asks_exact(words), remarks);
    below_nought::sizes(question, variant, remarks);
}
