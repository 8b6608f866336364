//! What came of the examination of a question, as it is printed, kept in the cache and given to other programs.

use serde::{Deserialize, Serialize};

use super::coverage::Coverage;
use super::finding::Finding;
use super::shows::Slips;
use crate::bank::{Question, Style};
use crate::expr::print;
use crate::generate::Census;

/// A question examined.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Each style, in the order of the file.
    pub styles: Vec<StyleReport>,
    /// What is amiss.
    pub findings: Vec<Finding>,
    /// The marks that students won and lost.
    pub coverage: Coverage,
}

/// The census of a style in words and numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct StyleReport {
    /// Its name.
    pub style: String,
    /// How many sets of numbers its parameters have.
    pub sets: u64,
    /// How many of them have been examined: all, but of very many.
    pub examined: u64,
    /// How many of them are fit for print.
    pub variants: u64,
    /// What turns the others away, in the order in which that is examined.
    pub turned_away: Vec<Turned>,
    /// The form of each answer.
    pub forms: Vec<AnswerForms>,
    /// The slips that some of its variants hide.
    pub hidden: Vec<Hidden>,
}

/// Something that turns sets of numbers away.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Turned {
    /// What it is, in words.
    pub reason: String,
    /// The requirement as it was written, if it is one.
    pub requirement: Option<String>,
    /// How many it turns away that came so far.
    pub count: u64,
    /// How many variants there would be more without it; an estimate, unless all were asked.
    pub alone: u64,
    /// Of how many that it turned away one was asked whether nothing else would have turned it away.
    pub one_in: u64,
}

/// In how many variants an answer has which form.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct AnswerForms {
    /// The answer's name.
    pub answer: String,
    /// `whole`, `fraction`, `surd`, `decimal` or `letters`, and how many variants; the simplest first.
    pub forms: Vec<(String, u64)>,
}

/// A slip that does not show everywhere.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Hidden {
    /// Its tag.
    pub slip: String,
    /// In how many variants.
    pub count: u64,
}

impl StyleReport {
    /// The report of a style that has been counted.
    pub fn new(question: &Question, style: &Style, census: &Census, slips: &Slips, acting: u128) -> StyleReport {
        let reasons = census.funnel(question, style);
        let turned_away = census.unfit.iter().zip(reasons).map(|((unfit, count), (reason, _))| Turned {
            reason,
            requirement: unfit.requirement().and_then(|place| Some(style.require.get(place)?.text.clone())),
            count: *count,
            alone: census.alone.get(unfit).copied().unwrap_or(0),
            one_in: census.asked(unfit),
        });
        let answers = question.parts.iter().flat_map(|part| &part.answers);
        let forms = answers.zip(&census.forms).map(|(answer, forms)| AnswerForms {
            answer: print::text_unicode(&answer.name),
            forms: forms.iter().map(|(form, count)| (form.name().to_owned(), *count)).collect(),
        });
        let hidden = slips.hidden(acting).into_iter();
        StyleReport {
            style: style.name.name().to_owned(),
            sets: census.size,
            examined: census.examined,
            variants: census.fit,
            turned_away: turned_away.collect(),
            forms: forms.collect(),
            hidden: hidden.map(|(slip, count, _)| Hidden { slip: slip.to_owned(), count }).collect(),
        }
    }

    /// The requirement that turns most sets away.
    pub fn dearest(&self) -> Option<&Turned> {
        let required = self.turned_away.iter().filter(|turned| turned.requirement.is_some());
        required.reduce(|dearest, next| if next.count > dearest.count { next } else { dearest })
    }

    /// The requirement without which there would be most variants more; none if no single one keeps any out.
    pub fn relaxation(&self) -> Option<&Turned> {
        let required = self.turned_away.iter().filter(|turned| turned.requirement.is_some() && turned.alone > 0);
        required.reduce(|best, next| if next.alone > best.alone { next } else { best })
    }

    /// The forms of all answers together, the simplest first.
    pub fn all_forms(&self) -> Vec<(String, u64)> {
        let mut all: Vec<(String, u64)> = Vec::new();
        for form in crate::generate::Form::ALL {
            let each = self.forms.iter().flat_map(|answer| &answer.forms).filter(|(name, _)| name == form.name());
            let count: u64 = each.map(|(_, count)| count).sum();
            if count > 0 {
                all.push((form.name().to_owned(), count));
            }
        }
        all
    }
}
