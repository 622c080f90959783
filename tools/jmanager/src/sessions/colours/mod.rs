//! The colour tuner: a profile under edit for each session.

mod boundary;
mod limits;
mod score;

use std::fs;
use std::sync::Arc;

use bica_evaluation::profile::{self, CLASSES, Notes};
use bica_link::{Description, Plain};
use bica_vision::colour::{Classify, Colour, Filters};
use bica_vision::frame::{Frame, Pixel};
use bica_vision::profile::BUILT_IN;
use bica_vision::table::CompactTable;
use serde_json::{Value, json};

use super::history::StoredImage;
use super::session::Session;
use super::{commands, files, storage};
use crate::pages::PageId;
use crate::protocol::binary::{ImageHead, PixelKind};
use crate::protocol::{Failed, Request, Setting};
use limits::Limits;

/// Colour of each class on the page.
const SHOWN: [&str; 5] = ["#ff8c1a", "#ffd91a", "#3399ff", "#33b34d", "#f2f2f2"];
/// Number of changes that can be undone.
const MAX_UNDO: usize = 1000;
/// Largest number of pixels of one request.
const MAX_PIXELS: usize = 100_000;
/// Number of picked pixels of a class that are remembered.
const MAX_PICKED: usize = 10_000;
/// Class of a pixel without one, in a binary frame.
const NO_CLASS: u8 = 255;
/// Component of the robot with the limits as parameters.
const COMPONENT: &str = "Colours";
/// Name with which [`Request::LoadColours`] loads the limits of the robot.
const OF_ROBOT: &str = "robot";

/// A profile under edit.
#[derive(Clone, Debug)]
pub(super) struct Edit {
    /// In the order of [`CLASSES`].
    limits: [Limits; 5],
    /// Pixels that were assigned to each class.
    picked: [Vec<Pixel>; 5],
    undo: Vec<[Limits; 5]>,
}

impl Edit {
    fn new(filters: &Filters) -> Self {
        let limits = filters.in_order().map(|(_, filter)| Limits::from(filter));
        Self { limits, picked: Default::default(), undo: Vec::new() }
    }

    /// The limits that are in force in a robot; those of the built-in profile for a robot without such parameters.
    fn of_robot(description: Option<&Description>) -> Self {
        let mut edit = Self::new(&BUILT_IN);
        let component = description.and_then(|tree| tree.components.iter().find(|one| one.name == COMPONENT));
        let Some(component) = component else { return edit };
        let value = |name: &str| {
            let param = component.params.iter().find(|param| param.name == name)?;
            if let bica::Value::U32(value) = param.current() { Some(u64::from(value)) } else { None }
        };
        for (class, limits) in CLASSES.iter().zip(&mut edit.limits) {
            let of = |what: &str| value(&format!("{class}_{what}"));
            if let Some((from, to)) = of("hue_from").zip(of("hue_to")) {
                limits.hue = Some((from as i16, to as i16));
            }
            limits.saturation.0 = of("saturation_min").map_or(limits.saturation.0, |value| value as u16);
            limits.saturation.1 = of("saturation_max").map_or(limits.saturation.1, |value| value as u16);
            limits.luma.0 = of("luma_min").map_or(limits.luma.0, |value| value as u8);
            limits.luma.1 = of("luma_max").map_or(limits.luma.1, |value| value as u8);
            limits.chroma = of("chroma_min").map_or(limits.chroma, |value| value as u8);
        }
        edit
    }

    fn filters(&self) -> Filters {
        let [orange, yellow, blue, green, white] = self.limits.map(|limits| limits.filter());
        Filters { orange, yellow, blue, white, green }
    }

    fn begin_change(&mut self) {
        if self.undo.len() >= MAX_UNDO {
            self.undo.remove(0);
        }
        self.undo.push(self.limits);
    }

    fn pick(&mut self, class: usize, remove: bool, pixels: &[Pixel]) {
        self.begin_change();
        for &pixel in pixels {
            if remove {
                self.picked[class].retain(|picked| limits::cell(*picked) != limits::cell(pixel));
                if self.limits[class].has(pixel) || self.limits[class].filter().accepts(limits::cell(pixel)) {
                    self.limits[class] = self.limits[class].shrunk(pixel, &self.picked[class]);
                }
            } else {
                self.limits[class] = self.limits[class].grown(pixel);
                if self.picked[class].len() < MAX_PICKED {
                    self.picked[class].push(pixel);
                }
            }
        }
    }

    fn to_json(&self) -> Value {
        let class = |((name, colour), limits): ((&str, &str), &Limits)| json!({ "name": name, "colour": colour, "limits": limits });
        let classes: Vec<Value> = CLASSES.into_iter().zip(SHOWN).zip(&self.limits).map(class).collect();
        let text = profile::write(&self.filters(), &Notes::default());
        json!({ "classes": classes, "text": text, "undo": self.undo.len() })
    }

    /// The settings of the robot's parameters.
    fn settings(&self, description: &Description) -> Result<Vec<Setting>, Failed> {
        let none = || Failed::new("this robot has no parameters of colours", "save the profile instead");
        let position = description.components.iter().position(|one| one.name == COMPONENT).ok_or_else(none)?;
        let params = &description.components[position].params;
        let value = |name: &str| {
            let (class, what) = name.split_once('_')?;
            let limits = &self.limits[CLASSES.iter().position(|one| *one == class)?];
            Some(match what {
                "hue_from" => limits.hue?.0 as u64,
                "hue_to" => limits.hue?.1 as u64,
                "saturation_min" => u64::from(limits.saturation.0),
                "saturation_max" => u64::from(limits.saturation.1.min(1000)),
                "luma_min" => u64::from(limits.luma.0),
                "luma_max" => u64::from(limits.luma.1),
                "chroma_min" => u64::from(limits.chroma),
                _ => return None,
            })
        };
        let setting = |(param, described): (usize, &bica_link::Param)| {
            value(&described.name).map(|value| Setting {
                component: position,
                param,
                value: Plain::Integer(value as i64),
            })
        };
        Ok(params.iter().enumerate().filter_map(setting).collect())
    }
}

/// Handles a request of the colour tuner. Returns the answer; none if it follows later.
pub(super) fn handle(
    session: &Arc<Session>,
    page: PageId,
    id: u32,
    request: &Request,
) -> Result<Option<Value>, Failed> {
    let mut edit = {
        let shared = session.shared();
        shared.colours.clone().unwrap_or_else(|| Edit::of_robot(shared.description.as_deref()))
    };
    match request {
        Request::PickColours { class, remove, image, pixels, .. } => {
            let pixels = pixels_of(&session.image(*image)?, pixels)?;
            if *class >= CLASSES.len() {
                return Err(super::value::unknown("colour class", *class));
            }
            edit.pick(*class, *remove, &pixels);
        }
        Request::UndoColours { .. } => {
            let last = edit.undo.pop();
            edit.limits = last.ok_or_else(|| Failed::new("there is nothing to undo", "pick pixels first"))?;
        }
        Request::LoadColours { name, .. } => {
            let loaded = match name.as_str() {
                OF_ROBOT => Edit::of_robot(session.shared().description.as_deref()),
                _ => Edit::new(&load(session, name)?),
            };
            edit.begin_change();
            edit.limits = loaded.limits;
            edit.picked = Default::default();
        }
        Request::Classify { image, .. } => {
            let frame = classified(session, &session.image(*image)?, &edit, id)?;
            session.pages.binary(page, frame.into());
            return Ok(Some(Value::Null));
        }
        Request::Boundary { image, .. } => {
            let found = boundary::find(session, &session.image(*image)?, &edit.filters())?;
            return Ok(Some(json!(found)));
        }
        Request::ScoreColours { .. } => return score::start(session, page, id, &edit.filters()).map(|()| None),
        Request::SendColours { .. } => {
            let settings = edit.settings(&*session.description()?)?;
            let request = Request::Set { settings };
            return session.command(commands::Command::Operate { page, id, request }).map(|()| None);
        }
        Request::SaveColours { name, .. } => {
            let path = files::path(&session.options.profiles, name, ".toml")?;
            storage::replace(&path, profile::write(&edit.filters(), &Notes::default()).as_bytes())?;
            return Ok(Some(json!({ "path": path.display().to_string() })));
        }
        // Until something is changed, the limits that are in force are those of the robot.
        _ => return Ok(Some(edit.to_json())),
    }
    let answer = edit.to_json();
    if !matches!(request, Request::Colours {}) {
        session.shared().colours = Some(edit);
    }
    Ok(Some(answer))
}

/// Loads a profile by name: a built-in one, or a file in the folder of profiles.
fn load(session: &Session, name: &str) -> Result<Filters, Failed> {
    let path = files::path(&session.options.profiles, name, ".toml")?;
    let source = if fs::exists(&path).unwrap_or(false) { path.display().to_string() } else { name.to_owned() };
    if source != name {
        files::open(&path).map_err(|error| storage::failed("read", &path, &error, "choose another profile"))?;
    } else if !["built-in", "nao2009", "darwin2013"].contains(&name) {
        let what = format!("there is no profile `{name}` in `{}`", session.options.profiles.display());
        return Err(Failed::new(what, "known are its files, built-in, nao2009 and darwin2013"));
    }
    Ok(profile::load(&source)?)
}

fn pixels_of(image: &StoredImage, places: &[(u16, u16)]) -> Result<Vec<Pixel>, Failed> {
    if places.is_empty() || places.len() > MAX_PIXELS {
        return Err(Failed::new(format!("{} pixels", places.len()), format!("pick 1 to {MAX_PIXELS} pixels")));
    }
    let width = usize::from(image.width);
    let pixel = |&(x, y): &(u16, u16)| {
        let is_inside = x < image.width && y < image.height;
        let pair = 4 * (usize::from(y) * (width / 2) + usize::from(x / 2));
        let pair = image.yuyv.get(pair..pair + 4).filter(|_| is_inside);
        let outside = || Failed::new(format!("({x}, {y}) is outside the image"), "pick pixels of the image");
        pair.map(|pair| Pixel::new(pair[usize::from(x % 2) * 2], pair[1], pair[3])).ok_or_else(outside)
    };
    places.iter().map(pixel).collect()
}

/// Returns the binary frame with the class of each pixel, by the table that the robot uses.
fn classified(session: &Session, image: &StoredImage, edit: &Edit, id: u32) -> Result<Vec<u8>, Failed> {
    let table = Box::new(CompactTable::compile(&edit.filters()));
    let frame = Frame::new(image.width, image.height, &image.yuyv);
    frame.map_err(|error| Failed::new(error.to_string(), "choose another image"))?;
    let index = |colour: Colour| match colour {
        Colour::None => NO_CLASS,
        Colour::Orange => 0,
        Colour::Yellow => 1,
        Colour::Blue => 2,
        Colour::Green => 3,
        Colour::White => 4,
    };
    let pairs = image.yuyv.as_chunks::<4>().0.iter();
    let classes: Vec<u8> = pairs
        .flat_map(|&[left, cb, right, cr]| [left, right].map(|y| index(table.classify(Pixel::new(y, cb, cr)))))
        .collect();
    let head = ImageHead {
        kind: PixelKind::Classes,
        bottom_camera: image.bottom_camera,
        session: session.id,
        number: image.number,
        width: image.width,
        height: image.height,
        time_us: image.time_us,
        id,
    };
    Ok(head.frame(&classes))
}
