//! Text on a picture, in the bitmap fonts of embedded-graphics.

use embedded_graphics::Drawable;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_1 as fonts};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::text::{Baseline, Text};
use glam::Vec2;

use super::canvas::{Canvas, Ink};

/// Size and weight of letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Font {
    /// 6×10 pixels.
    Small,
    /// 7×13 pixels.
    Normal,
    /// 7×13 pixels, bold.
    Bold,
    /// 9×18 pixels, bold.
    Title,
}

impl Font {
    const fn letters(self) -> &'static MonoFont<'static> {
        match self {
            Self::Small => &fonts::FONT_6X10,
            Self::Normal => &fonts::FONT_7X13,
            Self::Bold => &fonts::FONT_7X13_BOLD,
            Self::Title => &fonts::FONT_9X18_BOLD,
        }
    }

    /// Returns the width of a text, px.
    #[must_use]
    pub fn width(self, text: &str) -> f32 {
        text.chars().count() as f32 * self.letters().character_size.width as f32
    }

    /// Returns the height of a line, px.
    #[must_use]
    pub const fn height(self) -> f32 {
        self.letters().character_size.height as f32
    }
}

impl Canvas {
    /// Writes a line with its upper left corner at `at`. Letters outside Latin-1 become `?`.
    pub fn write(&mut self, at: Vec2, font: Font, ink: impl Into<Ink>, text: &str) {
        let style = MonoTextStyle::new(font.letters(), BinaryColor::On);
        let at = Point::new(at.x.round() as i32, at.y.round() as i32);
        let Ok(_) =
            Text::with_baseline(text, at, style, Baseline::Top).draw(&mut Pen { canvas: self, ink: ink.into() });
    }

    /// Writes a line with its centre at `at`.
    pub fn write_centred(&mut self, at: Vec2, font: Font, ink: impl Into<Ink>, text: &str) {
        self.write(at - 0.5 * Vec2::new(font.width(text), font.height()), font, ink, text);
    }
}

struct Pen<'a> {
    canvas: &'a mut Canvas,
    ink: Ink,
}

impl OriginDimensions for Pen<'_> {
    fn size(&self) -> Size {
        Size::new(self.canvas.width() as u32, self.canvas.height() as u32)
    }
}

impl DrawTarget for Pen<'_> {
    type Color = BinaryColor;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(at, dot) in pixels {
            if dot.is_on() {
                self.canvas.blend(at.x, at.y, self.ink, 1.0);
            }
        }
        Ok(())
    }
}
