//! Logarithmic scales, and powers of ten as people write them.

/// A scale on which each power of ten is as long as any other.
#[derive(Clone, Copy, Debug)]
pub struct Decades {
    /// The exponents at its ends.
    pub from: i32,
    pub to: i32,
    /// The places of its ends.
    pub start: f64,
    pub end: f64,
}

impl Decades {
    /// The scale over all of some positive numbers.
    pub fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Decades {
        let (mut from, mut to) = (i32::MAX, i32::MIN);
        for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
            from = from.min(value.log10().floor() as i32);
            to = to.max(value.log10().ceil() as i32);
        }
        if from >= to {
            (from, to) = if from == i32::MAX { (0, 1) } else { (from, from + 1) };
        }
        Decades { from, to, start, end }
    }

    /// Where a number stands.
    pub fn place(&self, value: f64) -> f64 {
        self.start + (value.log10() - f64::from(self.from)) / f64::from(self.to - self.from) * (self.end - self.start)
    }

    /// The powers of ten to be written, every `step`-th so that they are at least so far apart.
    pub fn ticks(&self, apart: f64) -> impl Iterator<Item = i32> + use<> {
        let each = (self.end - self.start).abs() / f64::from(self.to - self.from);
        let step = [1, 2, 3, 5, 10].into_iter().find(|step| f64::from(*step) * each >= apart).unwrap_or(20);
        (self.from..=self.to).filter(move |exponent| exponent % step == 0)
    }
}

/// `10⁻³`, `1`, `10`, `10⁶`.
pub fn power(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => {
            let raised = |digit: char| match digit {
                '-' => '⁻',
                '0' => '⁰',
                '1' => '¹',
                '2' => '²',
                '3' => '³',
                _ => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
            };
            format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_written_as_on_paper() {
        assert_eq!([-16, 0, 1, 2, 13].map(power), ["10⁻¹⁶", "1", "10", "10²", "10¹³"]);
    }

    #[test]
    fn a_decade_is_as_long_as_another() {
        let scale = Decades::over([2.0, 450.0].into_iter(), 0.0, 300.0);
        assert_eq!((scale.from, scale.to), (0, 3));
        assert_eq!(scale.place(10.0), 100.0);
        assert_eq!(scale.ticks(50.0).collect::<Vec<_>>(), [0, 1, 2, 3]);
        assert_eq!(scale.ticks(150.0).collect::<Vec<_>>(), [0, 2]);
    }
}
