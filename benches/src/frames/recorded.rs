//! Recorded frames, if they are available beside the repository.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use bica_vision::profile::{DARWIN_2013, NAO_2009};
use bica_vision::projection::{Camera, Intrinsics};
use bica_vision::table::CompactTable;
use glam::{Affine3A, Mat3, Vec2, Vec3};

use super::{FrameSet, Sample};

/// Returns the folder of the images; `None`, after one message, if it is missing.
#[must_use]
pub fn folder() -> Option<&'static Path> {
    static FOLDER: LazyLock<Option<&'static Path>> = LazyLock::new(|| {
        let folder = bica_test_data::images();
        if folder.is_dir() {
            return Some(folder);
        }
        eprintln!(
            "recorded frames are skipped: no folder {}; set BICA_SHARED to the folder of images/",
            folder.display()
        );
        None
    });
    *FOLDER
}

/// Loads the recorded frames of two robots, scaled from 320×240 px.
#[must_use]
pub fn frame_sets(folder: &Path, size: (u16, u16)) -> Vec<FrameSet> {
    let poses = poses(folder);
    let frame_set = |(name, filters)| {
        let samples = files(&folder.join(name)).into_iter().map(|file| {
            let key = format!("{name}/{}", file.file_name().unwrap_or_default().to_string_lossy());
            let pose = poses.iter().find(|(file, _)| *file == key).map(|(_, pose)| *pose);
            sample(key, &read(&file), size, pose)
        });
        FrameSet { name, table: CompactTable::compile(filters), samples: samples.collect() }
    };
    [("nao2009", &NAO_2009), ("darwin2013", &DARWIN_2013)].map(frame_set).into()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of images");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    files
}

/// Camera poses of `nao2009`, by file.
fn poses(folder: &Path) -> Vec<(String, Affine3A)> {
    let text = fs::read_to_string(folder.join("nao2009_pose.csv")).expect("nao2009_pose.csv");
    let pose = |line: &str| {
        let (file, rest) = line.split_once(',').expect("a line of a table");
        let n: Vec<f32> = rest.split(',').skip(1).take(12).map(|cell| cell.parse().expect("a number")).collect();
        let turn = Mat3::from_cols_array(&[n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]]).transpose();
        (file.to_owned(), Affine3A::from_mat3_translation(turn, Vec3::new(n[9], n[10], n[11]) / 1000.0))
    };
    text.lines().skip(1).map(pose).collect()
}

/// Scales an image of 320×240 px to another size by doubling or halving pixels.
fn sample(name: String, rgb: &[[u8; 3]], (width, height): (u16, u16), pose: Option<Affine3A>) -> Sample {
    let at = |x: u16, y: u16| {
        let (x, y) = (u32::from(x) * 320 / u32::from(width), u32::from(y) * 240 / u32::from(height));
        rgb[(320 * y + x) as usize]
    };
    let pairs = (0..height).flat_map(|y| (0..width).step_by(2).map(move |x| (x, y)));
    let yuyv = pairs.flat_map(|(x, y)| pair(at(x, y), at(x + 1, y))).collect();
    let intrinsics = Intrinsics {
        focal: Vec2::splat(385.54 / 320.0 * f32::from(width)),
        centre: 0.5 * Vec2::new(f32::from(width), f32::from(height)),
    };
    Sample { name, width, height, yuyv, camera: pose.map(|pose| Camera::new(pose, intrinsics)) }
}

fn read(path: &Path) -> Vec<[u8; 3]> {
    let decoder = png::Decoder::new(BufReader::new(File::open(path).expect("an image")));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut rgb = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut rgb).expect("a whole PNG");
    assert_eq!((info.width, info.height), (320, 240), "{}", path.display());
    rgb.as_chunks::<3>().0.to_vec()
}

/// Converts two pixels to YUYV: full-range BT.601, mean chroma.
fn pair(left: [u8; 3], right: [u8; 3]) -> [u8; 4] {
    let ycc = |rgb: [u8; 3]| {
        let [r, g, b] = rgb.map(f32::from);
        let y = 0.299 * r + 0.587 * g + 0.114 * b;
        [y, 128.0 + (b - y) / 1.772, 128.0 + (r - y) / 1.402]
    };
    let ([y0, cb0, cr0], [y1, cb1, cr1]) = (ycc(left), ycc(right));
    [y0, 0.5 * (cb0 + cb1), y1, 0.5 * (cr0 + cr1)].map(|value| value.round().clamp(0.0, 255.0) as u8)
}
