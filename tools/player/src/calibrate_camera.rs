//! `player calibrate-camera`: the cameras of a NAO, from a recording.

use std::path::{Path, PathBuf};

use bica::Tree;
use bica_app::{Console, Failure, Outcome, interrupt};
use bica_evaluation::camera_calibration::{Calibrated, Residual, View, calibrate, view};
use bica_evaluation::profile;
use bica_motion::joints::{Joint, Joints};
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_player::tunable::Forward;
use bica_recording::{Recordable, Recording};
use bica_tuning::Layers;
use bica_vision::colour::Classify;
use bica_vision::table::CompactTable;
use clap::Args;
use serde::Serialize;

/// Largest turn of the head in a cycle, rad: images of a faster head are blurred, or of another moment.
const MAX_TURN: f32 = 0.02;
/// Largest change of a leg's joint, rad, in which the robot stands still.
const MAX_STEP: f32 = 0.05;
/// Error of a recording that cannot be read.
const RECORD: &str = "record a run of a NAO that stands, and moves its head, with `player play --record`";

/// Input and output of a calibration.
#[derive(Clone, Debug, Args)]
pub(crate) struct CameraOptions {
    /// Recording with images of a NAO that stands still and moves its head
    #[arg(value_name = "RECORDING")]
    recording: PathBuf,
    /// Where the middle between its feet is, and its heading, field frame: m, m and rad. On the mark before the attacked goal: 1.2,0,0
    #[arg(long, value_name = "X,Y,THETA", value_parser = pose, allow_hyphen_values = true)]
    pose: Pose2,
    /// Colour profile, by name or file
    #[arg(long, value_name = "FILE|NAME", default_value = "built-in")]
    profile: String,
    /// Tune file of the robot to which the angles of the cameras are written, `tune/NAME.toml` for --robot NAME
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Replace these values in an existing file; its other values are kept
    #[arg(long, requires = "out")]
    force: bool,
    /// Print the result as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    json: bool,
}

/// Result as JSON. Angles in rad.
#[derive(Serialize)]
struct Report {
    schema: &'static str,
    /// Number of images with lines: top and bottom camera.
    images: [usize; 2],
    /// Roll, tilt and pan.
    top: [f32; 3],
    bottom: [f32; 3],
    /// Roll and pitch.
    body: [f32; 2],
    before: Figures,
    after: Figures,
    file: Option<String>,
}

#[derive(Serialize)]
struct Figures {
    rms_px: f32,
    on_line: f32,
}

impl From<Residual> for Figures {
    fn from(Residual { rms, on_line }: Residual) -> Self {
        Self { rms_px: rms, on_line }
    }
}

/// Calibrates the cameras, prints the angles, and writes them.
pub(crate) fn run(args: &CameraOptions) -> Result<Outcome, Failure> {
    let colours = CompactTable::compile(&profile::load(&args.profile)?);
    let views = views(&args.recording, &colours)?;
    if interrupt::requested() {
        return Ok(Outcome::Interrupted);
    }
    let calibrated = calibrate(views, args.pose).map_err(|(what, help)| Failure::new(what, help))?;
    if let Some(path) = &args.out {
        write(&calibrated, path, args.force)?;
    }
    print(&calibrated, args)?;
    Ok(Outcome::Success)
}

/// Lines in the images up to the first step of the robot.
fn views(path: &Path, colours: &impl Classify) -> Result<Vec<View>, Failure> {
    let failed = |error: bica_recording::Error| Failure::of_path("read", path, &error, error.help());
    let mut recording = Recording::open(path).map_err(failed)?;
    let options = recording.header().set_up.get("options").and_then(|options| options.as_array());
    if options.is_some_and(|all| all.iter().filter_map(|one| one.as_str()).any(|one| one.starts_with("body="))) {
        let what = format!("the angles in `{}` are corrected by --option body already", path.display());
        return Err(Failure::new(what, "record the run without this option"));
    }
    let (mut views, mut first, mut before) = (Vec::new(), None, None::<Joints>);
    while let Some(cycle) = recording.next_cycle().map_err(failed)? {
        let Some(message) = &cycle.sensors else { continue };
        let blobs = cycle.blob_bytes();
        let sensors = Forward::decode_sensors(message, &blobs);
        let sensors = sensors.ok_or_else(|| Failure::new("these are not the measurements of a NAO", RECORD))?;
        let change = |joint: Joint, from: &Joints| (sensors.angles[joint] - from[joint]).abs();
        let first = *first.get_or_insert(sensors.angles);
        if interrupt::requested()
            || Joint::ALL.into_iter().filter(|joint| is_of_leg(*joint)).any(|leg| change(leg, &first) > MAX_STEP)
        {
            break;
        }
        let rests =
            |from: Joints| [Joint::HeadYaw, Joint::HeadPitch].into_iter().all(|head| change(head, &from) <= MAX_TURN);
        if before.replace(sensors.angles).is_some_and(rests) {
            views.extend(view(&sensors, colours));
        }
    }
    Ok(views)
}

fn is_of_leg(joint: Joint) -> bool {
    let name = format!("{joint:?}");
    ["Hip", "Knee", "Ankle"].iter().any(|part| name.contains(part))
}

/// Roll, tilt and pan of a camera, rad.
fn angles(calibrated: &Calibrated, camera: CameraId) -> [f32; 3] {
    let mounting = calibrated.offsets.mounting(camera);
    [mounting.roll, mounting.tilt, mounting.pan]
}

/// Writes the angles of the cameras that were calibrated to a tune file.
fn write(calibrated: &Calibrated, path: &Path, replace: bool) -> Result<(), Failure> {
    let mut layers = Layers::new(const { &Forward::GRAPH });
    if replace && path.exists() {
        layers.read(path)?;
    }
    for (camera, name) in [(CameraId::Top, "top"), (CameraId::Bottom, "bottom")] {
        if calibrated.images[camera as usize] > 0 {
            for (angle, value) in ["roll", "tilt", "pan"].into_iter().zip(angles(calibrated, camera)) {
                layers.assign(&format!("CameraPose.{name}_{angle}={value:.4}"), "calibration")?;
            }
        }
    }
    Ok(bica_tuning::write(&layers, path, replace)?)
}

fn print(calibrated: &Calibrated, args: &CameraOptions) -> Result<(), Failure> {
    let console = Console::new(args.json);
    let Calibrated { images, before, after, .. } = *calibrated;
    let degrees = |angle: f32| format!("{:+.2}°", angle.to_degrees());
    for (camera, name) in [(CameraId::Top, "top"), (CameraId::Bottom, "bottom")] {
        let [roll, tilt, pan] = angles(calibrated, camera).map(degrees);
        let count = images[camera as usize];
        let found = format!("roll {roll}, tilt {tilt}, pan {pan}, from {count} images with lines");
        let text = if count > 0 { found } else { "too few images with lines: not calibrated".to_owned() };
        console.print_row(name, &text)?;
    }
    let [roll, pitch] = calibrated.offsets.body();
    let lean = format!("roll {}, pitch {}: --option body={roll:.4},{pitch:.4}", degrees(roll), degrees(pitch));
    console.print_row("body", &lean)?;
    let residual = |Residual { rms, on_line }| format!("{rms:.2} px, {:.0} % of the points on lines", 100.0 * on_line);
    console.print_row("residual before", &residual(before))?;
    console.print_row("residual after", &residual(after))?;
    let file = args.out.as_ref().map(|path| path.display().to_string());
    if let Some(file) = &file {
        console.print_row("written", file)?;
    }
    console.print_json(&Report {
        schema: "bica-player/calibrate-camera/1",
        images,
        top: angles(calibrated, CameraId::Top),
        bottom: angles(calibrated, CameraId::Bottom),
        body: [roll, pitch],
        before: before.into(),
        after: after.into(),
        file,
    })
}

/// Parses a pose on the carpet.
fn pose(text: &str) -> Result<Pose2, String> {
    let number = |part: &str| part.trim().parse().ok().filter(|number: &f32| number.abs() <= 10.0);
    match text.split(',').map(number).collect::<Option<Vec<f32>>>().as_deref() {
        Some(&[x, y, theta]) => Ok(Pose2::new(x, y, theta)),
        _ => Err("give x, y and heading with commas between them, each at most 10, as 1.2,0,0".to_owned()),
    }
}
