//! Recorded frames and their labels.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use bica_field::GoalColour;
use bica_test_data::images;
use bica_vision::frame::Frame;
use bica_vision::projection::{Camera, Intrinsics};
use csv::StringRecord;
use glam::{Affine3A, Mat3, Vec2, Vec3};

/// Labelled ball.
#[derive(Clone, Debug)]
pub(crate) struct BallLabel {
    pub(crate) centre: Vec2,
    pub(crate) radius: f32,
    pub(crate) orange: bool,
    pub(crate) flag: String,
}

/// Labelled goal.
#[derive(Clone, Debug)]
pub(crate) struct GoalLabel {
    pub(crate) min: Vec2,
    pub(crate) max: Vec2,
    pub(crate) colour: GoalColour,
    pub(crate) complete: bool,
}

/// Labelled frame.
pub(crate) struct Labelled {
    pub(crate) file: String,
    pub(crate) balls: Vec<BallLabel>,
    pub(crate) goal: Option<GoalLabel>,
    pub(crate) size: (u16, u16),
    pub(crate) yuyv: Vec<u8>,
}

impl Labelled {
    pub(crate) fn frame(&self) -> Frame<'_> {
        Frame::new(self.size.0, self.size.1, &self.yuyv).expect("a frame")
    }
}

/// Labelled frames of a folder.
pub(crate) fn labelled(folder: &str) -> Vec<Labelled> {
    let records = records("labels.csv");
    records
        .iter()
        .filter(|row| row[0].starts_with(folder) && !row.iter().any(|field| field.contains("unlabelled")))
        .map(read)
        .collect()
}

/// Rows of a CSV file of the recorded images, without the header.
fn records(file: &str) -> Vec<StringRecord> {
    let mut reader = csv::Reader::from_path(images().join(file)).expect("the file opens");
    reader.records().map(|row| row.expect("as many fields as the header")).collect()
}

fn read(row: &StringRecord) -> Labelled {
    let one = [&row[1], &row[2], &row[3], "orange", &row[4]].join(":");
    let list = if row[4].contains(':') { &row[4] } else { &one };
    let (width, height, yuyv) = yuyv(&images().join(&row[0]));
    Labelled {
        file: row[0].to_owned(),
        balls: list.split(';').filter_map(ball).collect(),
        goal: goal(&row[5]),
        size: (width, height),
        yuyv,
    }
}

fn ball(text: &str) -> Option<BallLabel> {
    let parts: Vec<&str> = text.split(':').collect();
    let number = |i: usize| parts.get(i).and_then(|part: &&str| part.parse::<f32>().ok());
    Some(BallLabel {
        centre: Vec2::new(number(0)?, number(1)?),
        radius: number(2)?,
        orange: parts[3] == "orange",
        flag: parts[4].to_owned(),
    })
}

fn goal(text: &str) -> Option<GoalLabel> {
    let parts: Vec<&str> = text.split(':').collect();
    let number = |i: usize| parts.get(i).and_then(|part: &&str| part.parse::<f32>().ok());
    Some(GoalLabel {
        min: Vec2::new(number(0)?, number(1)?),
        max: Vec2::new(number(2)?, number(3)?),
        colour: if parts[4] == "blue" { GoalColour::SkyBlue } else { GoalColour::Yellow },
        complete: parts[5] == "complete",
    })
}

/// Decodes a PNG to YUYV: full-range BT.601, with the mean chroma of two pixels.
fn yuyv(path: &Path) -> (u16, u16, Vec<u8>) {
    let decoder = png::Decoder::new(BufReader::new(File::open(path).expect("an image")));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut rgb).expect("a whole PNG");
    assert_eq!(info.color_type, png::ColorType::Rgb, "{}", path.display());
    let bytes = rgb.as_chunks::<6>().0.iter().copied().flat_map(pair).collect();
    (info.width as u16, info.height as u16, bytes)
}

fn pair([r0, g0, b0, r1, g1, b1]: [u8; 6]) -> [u8; 4] {
    let ycc = |r: u8, g: u8, b: u8| {
        let [r, g, b] = [r, g, b].map(f32::from);
        let y = 0.299 * r + 0.587 * g + 0.114 * b;
        [y, 128.0 + (b - y) / 1.772, 128.0 + (r - y) / 1.402]
    };
    let ([y0, cb0, cr0], [y1, cb1, cr1]) = (ycc(r0, g0, b0), ycc(r1, g1, b1));
    [y0, 0.5 * (cb0 + cb1), y1, 0.5 * (cr0 + cr1)].map(|value| value.round().clamp(0.0, 255.0) as u8)
}

/// Camera poses of `nao2009`: file, camera, row of the horizon at x = 159.5, and whether the pose is trusted.
pub(crate) fn poses() -> Vec<(String, Camera, f32, bool)> {
    let pose = |row: &StringRecord| {
        let n: Vec<f32> = (2..15).map(|field| row[field].parse().expect("a number")).collect();
        let turn = Mat3::from_cols_array(&[n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]]).transpose();
        let pose = Affine3A::from_mat3_translation(turn, Vec3::new(n[9], n[10], n[11]) / 1000.0);
        let intrinsics = Intrinsics { focal: Vec2::splat(385.54), centre: Vec2::new(160.0, 120.0) };
        (row[0].to_owned(), Camera::new(pose, intrinsics), n[12], &row[15] == "1")
    };
    records("nao2009_pose.csv").iter().map(pose).collect()
}
