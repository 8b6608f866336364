//! Does a mark tell strong students from weak ones? The point-biserial correlation of the mark, won or not, with what each
//! student earned elsewhere in the script.
//!
//! Elsewhere means in all other parts: the marks of one part hang together by the scheme, an accuracy mark on its method
//! mark, and would only say that they do. With fewer than [`FEWEST`] students, or when nearly all or nearly none won the
//! mark, the figure would be chance, and is not given.

/// With fewer students nothing is said.
pub(super) const FEWEST: usize = 10;

/// So many at least have won the mark, and so many have not: else one student would decide.
const FEWEST_OF_EACH: usize = 3;

/// How a mark discriminates, or why that is not said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discrimination {
    /// From -100 to 100 hundredths; negative if it was won by those who earned less elsewhere.
    Hundredths(i32),
    /// Too few students handed in.
    FewStudents,
    /// Nearly all won it, or nearly none.
    Alike,
    /// There is nothing else in the script, or all earned the same there.
    NothingElse,
}

/// Sums over students, of whole numbers: added up in any order they come to the same.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    students: i128,
    won: i128,
    rest: i128,
    rest_squared: i128,
    rest_of_winners: i128,
}

impl Sums {
    /// Adds a student who won the mark, or did not, and earned so many marks elsewhere.
    pub fn add(&mut self, won: bool, rest: usize) {
        let (won, rest) = (i128::from(won), rest as i128);
        self.students += 1;
        self.won += won;
        self.rest += rest;
        self.rest_squared += rest * rest;
        self.rest_of_winners += won * rest;
    }

    pub fn discrimination(&self) -> Discrimination {
        let Sums { students, won, rest, rest_squared, rest_of_winners } = *self;
        let (of_mark, of_rest) = (won * (students - won), students * rest_squared - rest * rest);
        if students < FEWEST as i128 {
            return Discrimination::FewStudents;
        }
        if won.min(students - won) < FEWEST_OF_EACH as i128 {
            return Discrimination::Alike;
        }
        if of_rest == 0 {
            return Discrimination::NothingElse;
        }
        let together = (students * rest_of_winners - won * rest) as f64;
        let correlation = together / ((of_mark as f64).sqrt() * (of_rest as f64).sqrt());
        Discrimination::Hundredths((100.0 * correlation).round() as i32)
    }
}

impl Discrimination {
    /// As it is printed: `0.31`, `-0.05`; nothing where nothing is said.
    ///
    /// ```
    /// use carom::mark::report::Discrimination;
    /// assert_eq!(Discrimination::Hundredths(-5).printed(), "-0.05");
    /// assert_eq!(Discrimination::FewStudents.printed(), "");
    /// ```
    pub fn printed(self) -> String {
        match self {
            Discrimination::Hundredths(hundredths) => {
                let sign = if hundredths < 0 { "-" } else { "" };
                let size = hundredths.unsigned_abs();
                format!("{sign}{}.{:02}", size / 100, size % 100)
            }
            _ => String::new(),
        }
    }

    /// Why nothing is said; empty if something is.
    pub fn why_not(self) -> &'static str {
        match self {
            Discrimination::Hundredths(_) => "",
            Discrimination::FewStudents => "fewer than 10 students",
            Discrimination::Alike => "nearly all won it, or nearly none",
            Discrimination::NothingElse => "nothing else to compare it with",
        }
    }

    /// Is it negative beyond what chance does among so many students: below nought by two standard errors?
    pub(super) fn is_against(self, students: usize) -> bool {
        let Discrimination::Hundredths(hundredths) = self else { return false };
        hundredths < 0 && i64::from(hundredths).pow(2) * students as i64 > 40_000
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(students: &[(bool, usize)]) -> Discrimination {
        let mut sums = Sums::default();
        students.iter().for_each(|(won, rest)| sums.add(*won, *rest));
        sums.discrimination()
    }

    #[test]
    fn a_mark_that_the_strong_win_discriminates_and_one_that_the_weak_win_is_against_them() {
        // By hand: of 10 students the five with 10 marks elsewhere win it and the five with none do not: 1.
        let apart: Vec<(bool, usize)> = (0..10).map(|place| (place < 5, if place < 5 { 10 } else { 0 })).collect();
        assert_eq!(of(&apart), Discrimination::Hundredths(100));
        let against: Vec<(bool, usize)> = apart.iter().map(|(won, rest)| (!won, *rest)).collect();
        assert_eq!(of(&against), Discrimination::Hundredths(-100));
        assert!(of(&against).is_against(10) && !of(&apart).is_against(10));
        // Rest 0 to 9, won by 0, 1, …, 4 and 9: 10·19 - 6·45 = -80 over √24·√825 = 140.7.
        let mixed: Vec<(bool, usize)> = (0..10).map(|rest| (rest < 5 || rest == 9, rest)).collect();
        assert_eq!(of(&mixed), Discrimination::Hundredths(-57));
        // Two standard errors of ten students are 0.63.
        assert!(!of(&mixed).is_against(10) && of(&mixed).is_against(13));
    }

    #[test]
    fn nothing_is_said_where_it_would_be_chance() {
        let many = |count: usize, won: usize| (0..count).map(|place| (place < won, place)).collect::<Vec<_>>();
        assert_eq!(of(&many(9, 4)), Discrimination::FewStudents);
        assert_eq!(of(&many(12, 2)), Discrimination::Alike);
        assert_eq!(of(&many(12, 10)), Discrimination::Alike);
        assert_eq!(of(&[(true, 4); 12]), Discrimination::Alike);
        let same: Vec<(bool, usize)> = (0..12).map(|place| (place < 6, 7)).collect();
        assert_eq!(of(&same), Discrimination::NothingElse);
        assert_eq!(of(&[]), Discrimination::FewStudents);
        assert!(Discrimination::FewStudents.why_not().contains(&FEWEST.to_string()));
    }
}
