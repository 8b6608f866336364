//! The source of a picture in the making: lengths and points as text. A sheet has thousands of them, so they are written
//! digit by digit and not by way of a formatter.

use super::Point;

/// The source of a picture.
#[derive(Default)]
pub struct Source {
    text: String,
}

impl Source {
    /// Nothing yet, with room for a picture of so many strokes and labels.
    pub fn for_marks(count: usize) -> Source {
        Source { text: String::with_capacity(300 + 140 * count) }
    }

    /// What has been written.
    pub fn finish(self) -> String {
        self.text
    }

    /// Words of the notation.
    pub fn put(&mut self, words: &str) -> &mut Source {
        self.text.push_str(words);
        self
    }

    /// A length with no more than two places, and none that say nothing.
    pub fn length(&mut self, length: f64) -> &mut Source {
        let hundredths = (length.abs() * 100.0 + 0.5) as u32;
        if length < 0.0 && hundredths > 0 {
            self.text.push('-');
        }
        self.whole(hundredths / 100);
        let (tenth, hundredth) = (hundredths / 10 % 10, hundredths % 10);
        if (tenth, hundredth) != (0, 0) {
            self.text.push('.');
            self.digit(tenth);
        }
        if hundredth != 0 {
            self.digit(hundredth);
        }
        self
    }

    /// Both coordinates of a point, with a sign between them.
    pub fn point(&mut self, point: Point, between: &str) -> &mut Source {
        self.length(point.x).put(between).length(point.y)
    }

    fn whole(&mut self, number: u32) {
        for place in [10_000_000, 1_000_000, 100_000, 10_000, 1_000, 100, 10] {
            if number >= place {
                self.digit(number / place % 10);
            }
        }
        self.digit(number % 10);
    }

    fn digit(&mut self, digit: u32) {
        self.text.push(char::from(b'0' + digit as u8));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_has_two_places_at_most() {
        let cases = [
            (0.0, "0"),
            (-0.001, "0"),
            (2.0, "2"),
            (2.1, "2.1"),
            (-0.254, "-0.25"),
            (12.049, "12.05"),
            (0.07, "0.07"),
            (-0.625, "-0.63"),
            (1200.0, "1200"),
            (12345678.5, "12345678.5"),
        ];
        for (length, written) in cases {
            let mut source = Source::default();
            source.length(length);
            assert_eq!(source.finish(), written);
        }
    }
}
