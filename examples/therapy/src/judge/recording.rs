//! Recorded skeletons in the format of UI-PRMD.

use std::fs;
use std::io::Read;
use std::path::Path;

use bica_app::Failure;
use flate2::read::MultiGzDecoder;
use glam::{Mat3, Vec3};

use crate::skeleton::{Layout, Skeleton};

const POINTS: usize = 22;

/// Parent of each point.
const PARENTS: [usize; POINTS] = [0, 0, 1, 2, 3, 4, 2, 6, 7, 8, 2, 10, 11, 12, 0, 14, 15, 16, 0, 18, 19, 20];

/// Reads the skeletons of a recording from its file of positions and its file of angles; a line without a skeleton is `None`.
pub(super) fn read(positions: &Path, angles: &Path) -> Result<Vec<Option<Skeleton>>, Failure> {
    let (offsets, turns) = (lines(positions)?, lines(angles)?);
    if offsets.len() != turns.len() {
        let what = format!("`{}` has {} lines, and its angles {}", positions.display(), offsets.len(), turns.len());
        return Err(Failure::new(what, "give both files with a line for each skeleton"));
    }
    Ok(offsets.iter().zip(&turns).map(|(offsets, turns)| Some(skeleton(offsets.as_ref()?, turns.as_ref()?))).collect())
}

/// Places the points along their parents. Each offset is in the frame of the parent; each rotation (Z · Y · X, degrees)
/// is relative to it. Source: the description of UI-PRMD.
fn skeleton(offsets: &[Vec3; POINTS], turns: &[Vec3; POINTS]) -> Skeleton {
    let mut points = [Vec3::ZERO; POINTS];
    let mut frames = [Mat3::IDENTITY; POINTS];
    for point in 0..POINTS {
        let parent = PARENTS[point];
        points[point] = points[parent] + frames[parent] * offsets[point];
        let [x, y, z] = turns[point].to_array().map(f32::to_radians);
        frames[point] = frames[parent] * Mat3::from_rotation_z(z) * Mat3::from_rotation_y(y) * Mat3::from_rotation_x(x);
    }
    let confidence = points.map(|point| f32::from(u8::from(point.is_finite())));
    Layout::Kinect22.read(&points, &confidence).expect("as many points as the layout has")
}

type Line = Option<[Vec3; POINTS]>;

fn lines(path: &Path) -> Result<Vec<Line>, Failure> {
    let text = text(path)?;
    let parsed = text.lines().enumerate().map(|(index, line)| {
        parse(line).ok_or_else(|| {
            let place = format!("`{}`, line {}", path.display(), index + 1);
            let what = format!("{place}: not {} numbers with commas between them", 3 * POINTS);
            Failure::new(what, "give the files of UI-PRMD for a Kinect: 22 points with three numbers each")
        })
    });
    parsed.collect()
}

/// Parses a line. An empty line, or one with a number that is not finite, has no skeleton; `None` if the line is malformed.
fn parse(line: &str) -> Option<Line> {
    if line.trim().is_empty() {
        return Some(None);
    }
    let numbers: Vec<f32> = line.split(',').map(|number| number.trim().parse().ok()).collect::<Option<_>>()?;
    let points = || std::array::from_fn(|point| Vec3::from_slice(&numbers[3 * point..]));
    let line: [Vec3; POINTS] = (numbers.len() == 3 * POINTS).then(points)?;
    Some(line.iter().all(|point| point.is_finite()).then_some(line))
}

/// Reads a file, which may be compressed with gzip.
fn text(path: &Path) -> Result<String, Failure> {
    let failed = |error| Failure::of_path("read", path, &error, "give a text file, or one compressed with gzip");
    let bytes = fs::read(path).map_err(failed)?;
    let (mut text, packed) = (String::new(), bytes.starts_with(&[0x1f, 0x8b]));
    let mut reader: Box<dyn Read> = if packed { Box::new(MultiGzDecoder::new(&*bytes)) } else { Box::new(&*bytes) };
    reader.read_to_string(&mut text).map_err(failed)?;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::skeleton::Point;

    #[test]
    fn offsets_turn_with_their_parents() {
        let (mut offsets, mut turns) = ([Vec3::ZERO; POINTS], [Vec3::ZERO; POINTS]);
        (offsets[0], offsets[1], offsets[2]) = (Vec3::X, Vec3::Y, Vec3::Y);
        (turns[0], turns[1]) = (Vec3::new(0.0, 0.0, 90.0), Vec3::new(90.0, 0.0, 0.0));
        let chest = skeleton(&offsets, &turns).at(Point::Chest);
        assert!(chest.distance(Vec3::new(0.0, 0.0, 1.0)) < 1e-6, "{chest}");
    }

    #[test]
    fn a_line_without_numbers_has_no_skeleton() {
        let numbers = ["1.5"; 66].join(",");
        assert_eq!(parse(&numbers), Some(Some([Vec3::splat(1.5); POINTS])));
        assert_eq!(parse(&numbers.replacen("1.5", "nan", 1)), Some(None));
        assert_eq!((parse(""), parse("1,2"), parse(&numbers.replacen("1.5", "x", 1))), (Some(None), None, None));
    }
}
