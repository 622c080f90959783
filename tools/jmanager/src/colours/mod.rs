//! The colour tuner: a profile under edit for each session.

mod answer;
pub(super) mod boundary;
mod limits;
mod score;

use std::fs;
use std::path::{Path, PathBuf};

use bica_evaluation::profile::{self, CLASSES, Notes};
use bica_link::{Description, NamedSetting, Plain};
use bica_vision::colour::{Classify, Colour, Filters};
use bica_vision::frame::{Frame, Pixel};
use bica_vision::profile::BUILT_IN;
use bica_vision::table::CompactTable;
use serde::Deserialize;
use serde_json::{Value, json};

use bica_monitor::files;
use bica_monitor::program::{Asked, Extension, Image, Reply};
use bica_monitor::protocol::Failed;
use bica_wire::model::Invalid;
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
/// Name with which [`Request::Load`] loads the limits of the robot.
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

    /// Returns the limits that are in force in a robot; those of the built-in profile for a robot without such parameters.
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

    /// Returns the settings of the robot's parameters.
    fn settings(&self, description: &Description) -> Result<Vec<NamedSetting>, Failed> {
        let none = || Failed::new("this robot has no parameters of colours", "save the profile instead");
        let component = description.components.iter().find(|one| one.name == COMPONENT).ok_or_else(none)?;
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
        let setting = |param: &bica_link::Param| {
            let value = Plain::Integer(value(&param.name)? as i64);
            Some(NamedSetting { component: COMPONENT.to_owned(), param: param.name.clone(), value })
        };
        Ok(component.params.iter().filter_map(setting).collect())
    }
}

/// Memory of a session: the profile under edit, after its first change.
type Edited = Option<Edit>;

/// Requests of the panel.
#[derive(Debug, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Request {
    /// Reads the classes that are in force: `{"classes": [{"name", "colour", "limits": …}], "text": profile TOML}`.
    Read {},
    /// Assigns pixels of an image to a class, or removes them. Answer as `Read`.
    Pick { class: usize, remove: bool, image: u32, pixels: Vec<(u16, u16)> },
    /// Undoes the last change. Answer as `Read`.
    Undo {},
    /// Replaces the profile by a saved or built-in one, or by the limits of the `robot`. Answer as `Read`.
    Load { name: String },
    /// Classifies an image: a binary frame with the classes precedes the answer.
    Classify { image: u32 },
    /// Recall and precision on labelled images: `{"rows": [{"object", "recall", "precision", "images"}]}`.
    Score {},
    /// Sends the profile to the robot, as parameters.
    Send {},
    /// Saves the profile: `{"path": text}`.
    Save { name: String },
}

/// Returns the profile under edit of a session. Before the first change these are the limits that are in force in the robot.
fn edit_of(asked: &dyn Asked) -> Edit {
    let edit = asked.memory().of::<Edited>().clone();
    edit.unwrap_or_else(|| Edit::of_robot(asked.description().as_deref()))
}

/// The colour tuner.
pub(super) struct Tuner {
    /// Folder of saved profiles.
    pub(super) profiles: PathBuf,
    /// Folder of labelled images.
    pub(super) images: Option<PathBuf>,
}

impl Extension for Tuner {
    fn name(&self) -> &'static str {
        "tuner"
    }

    fn module(&self) -> &'static str {
        include_str!("../../panels/tuner.js")
    }

    fn only_reads(&self, message: &Value) -> bool {
        ["read", "classify", "score"].iter().any(|kind| message["type"] == *kind)
    }

    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed> {
        let request =
            serde_json::from_value(message).map_err(|error| Failed::new(error.to_string(), "reload the page"))?;
        let tree = asked.description();
        let mut edit = edit_of(asked);
        match request {
            Request::Classify { image } => return classify(asked, &asked.image(image)?, &edit),
            Request::Score {} => return score::start(asked, self.images.as_deref(), &edit.filters()),
            Request::Send {} => {
                let unknown = || Failed::new("nothing is known of this session yet", "wait until it is connected");
                return asked.set_params(edit.settings(&*tree.ok_or_else(unknown)?)?);
            }
            Request::Save { name } => {
                let path = files::path(&self.profiles, &name, ".toml")?;
                files::replace(&path, profile::write(&edit.filters(), &Notes::default()).as_bytes())?;
                return Ok(Reply::Done(json!({ "path": path.display().to_string() })));
            }
            Request::Read {} => return Ok(Reply::Done(edit.to_json())),
            Request::Pick { class, remove, image, pixels } => {
                let pixels = pixels_of(&asked.image(image)?, &pixels)?;
                if class >= CLASSES.len() {
                    return Err(Failed::new(format!("there is no colour class {class}"), "reload the page"));
                }
                edit.pick(class, remove, &pixels);
            }
            Request::Undo {} => {
                let last = edit.undo.pop();
                edit.limits = last.ok_or_else(|| Failed::new("there is nothing to undo", "pick pixels first"))?;
            }
            Request::Load { name } => {
                let loaded = match name.as_str() {
                    OF_ROBOT => Edit::of_robot(tree.as_deref()),
                    _ => Edit::new(&load(&self.profiles, &name)?),
                };
                edit.begin_change();
                edit.limits = loaded.limits;
                edit.picked = Default::default();
            }
        }
        let answer = edit.to_json();
        *asked.memory().of::<Edited>() = Some(edit);
        Ok(Reply::Done(answer))
    }
}

/// Loads a profile by name: a built-in one, or a file in the folder of profiles.
fn load(profiles: &Path, name: &str) -> Result<Filters, Failed> {
    let path = files::path(profiles, name, ".toml")?;
    let source = if fs::exists(&path).unwrap_or(false) { path.display().to_string() } else { name.to_owned() };
    if source != name {
        let unreadable = |error| Failed::new(format!("cannot read `{source}`: {error}"), "choose another profile");
        files::open(&path).map_err(unreadable)?;
    } else if !["built-in", "nao2009", "darwin2013"].contains(&name) {
        let what = format!("there is no profile `{name}` in `{}`", profiles.display());
        return Err(Failed::new(what, "known are its files, built-in, nao2009 and darwin2013"));
    }
    profile::load(&source).map_err(|failure| Invalid::from(failure).into())
}

fn pixels_of(image: &Image, places: &[(u16, u16)]) -> Result<Vec<Pixel>, Failed> {
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

/// Sends the class of each pixel, by the same kind of table as in the robot.
fn classify(asked: &dyn Asked, image: &Image, edit: &Edit) -> Result<Reply, Failed> {
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
    asked.send_classes(image, &classes);
    Ok(Reply::Done(Value::Null))
}
