"""Checks the topics for other programs in a recording, with the libraries of those who defined them.

Each topic is decoded by its own descriptors and by the official ones, and by Rerun. Images, annotations, frames, states and parameters
are compared with the exact values in the same file.
"""

import json
import argparse
import importlib
import io
import math
import sys

from google.protobuf.json_format import MessageToDict
from google.protobuf.unknown_fields import UnknownFieldSet
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from PIL import Image
from rerun.chunk import McapReader

from bica.recording.file import RecordingFile
from bica.recording.postcard import decoder

#: Component that Rerun makes of a message.
RERUN = {
    "foxglove.CompressedImage": "EncodedImage:blob",
    "foxglove.CameraCalibration": "Pinhole:image_from_camera",
    "foxglove.FrameTransforms": "Transform3D:translation",
    "foxglove.PointCloud": "Points3D:positions",
    "foxglove.Log": "TextLog:text",
    # Shown as the values of their fields.
    "foxglove.ImageAnnotations": "foxglove.ImageAnnotations:message",
    "foxglove.SceneUpdate": "foxglove.SceneUpdate:message",
    "bica.States": "bica.States:message",
    "bica.Parameters": "bica.Parameters:message",
}
#: Most images a second, and largest width, px.
IMAGES_PER_SECOND, MAX_WIDTH = 3.5, 320


def check(holds, text):
    """End the program unless a condition holds."""
    if not holds:
        sys.exit(f"{sys.argv[1]}: {text}")


def is_close(one, other, tolerance=1e-5):
    """Return whether numbers are equal but for rounding."""
    return len(one) == len(other) and all(math.isclose(a, b, rel_tol=tolerance, abs_tol=tolerance) for a, b in zip(one, other))


def official(name):
    """Return the official class of a message of Foxglove."""
    short = name.removeprefix("foxglove.")
    return getattr(importlib.import_module(f"foxglove_schemas_protobuf.{short}_pb2"), short)


def same_fields(own, other, seen):
    """Check that two descriptors have the same fields, and the messages and enumerations in them."""
    if own.full_name in seen:
        return
    seen.add(own.full_name)

    def fields(descriptor):
        return {(field.name, field.number, field.type, field.is_repeated) for field in descriptor.fields}

    differing = fields(own) ^ fields(other)
    check(not differing, f"{own.full_name} is not the official message: {sorted(differing)}")
    for field in own.fields:
        twin = other.fields_by_number[field.number]
        if field.message_type:
            same_fields(field.message_type, twin.message_type, seen)
        elif field.enum_type:
            values = [[(value.name, value.number) for value in one.enum_type.values] for one in (field, twin)]
            check(values[0] == values[1], f"{field.full_name} has other values: {values[0]}")


class Exact:
    """The exact values of a recording."""

    def __init__(self, path):
        self.file = RecordingFile(path)
        self.schemas = {schema.name: schema for schema in self.file.schemas.values()}
        self.components = self.file.header["tree"]["components"]
        self.infos = {
            f"{owner['name']}/{info['name']}": (component, index, info)
            for component, owner in enumerate(self.components)
            for index, info in enumerate(owner["info"])
        }
        self.outputs = dict(self._outputs())
        decode = decoder(json.loads(self.schemas["bica.TreeRecord"].data))
        self.trees = {message.log_time: decode(message.data) for _, _, message in self.file.messages("tree")}
        decode = decoder(json.loads(self.schemas["bica.BlobRecord"].data))
        self.widths = {m.log_time: self._width(decode(m.data)) for _, _, m in self.file.messages("blobs")}

    @staticmethod
    def _width(blob):
        return next(iter(blob["format"].values())).get("width") if isinstance(blob["format"], dict) else None

    def _outputs(self):
        decode = decoder(json.loads(self.schemas["bica.InformationRecord"].data))
        schemas = [[output.get("schema") for output in owner["info"]] for owner in self.components]
        decoders = [[schema and decoder(schema) for schema in owner] for owner in schemas]
        for _, _, message in self.file.messages("information"):
            values = {}
            for one in decode(message.data)["values"]:
                component, index = one["component"], one["index"]
                name = f"{self.components[component]['name']}/{self.components[component]['info'][index]['name']}"
                values[name] = decoders[component][index](one["value"]) if one["value"] else None
            yield message.log_time, values

    def state(self, tree, component):
        """Return the state of a component by name."""
        if not tree["active"][component // 8] >> component % 8 & 1:
            return "latent"
        state = tree["states"][component]
        return "active" if state == 255 else self.components[component]["states"][state]["name"]


def flat(value):
    """Return the values in options and lists."""
    if isinstance(value, (list, tuple)):
        return [one for part in value for one in flat(part)]
    return [] if value is None else [value]


def annotated(value, scale):
    """Return the circles and the lines that an output in an image stands for."""
    circles, lines = [], []
    for one in flat(value):
        if "radius" in one:
            circles.append([one["x"] * scale, one["y"] * scale, 2 * one["radius"] * scale])
        else:
            points = [one] if "x" in one else one.get("points") or [one["start"], one["end"]]
            lines.append([part * scale for point in points for part in (point["x"], point["y"])])
    return circles, lines


def pose(value):
    """Return position and quaternion of a pose on the ground or in space."""
    if "position" in value:
        return [[value[part][axis] for axis in axes] for part, axes in (("position", "xyz"), ("orientation", "xyzw"))]
    return [[value["x"], value["y"], 0.0], [0.0, 0.0, math.sin(value["heading"] / 2), math.cos(value["heading"] / 2)]]


def rotate(quaternion, vector):
    """Return a rotated vector."""
    x, y, z, w = quaternion
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return [sum(a * b for a, b in zip(row, vector)) for row in rows]


class Frames:
    """The frames of a message."""

    def __init__(self, message):
        self.places = {one["child_frame_id"]: (one["parent_frame_id"], one) for one in message["transforms"]}

    def place(self, frame, point, within):
        """Return a point of a frame in another frame; None if the frame is not in it."""
        while frame != within:
            if frame not in self.places:
                return None
            frame, one = self.places[frame]
            moved = rotate([one["rotation"][axis] for axis in "xyzw"], point)
            point = [a + one["translation"][axis] for a, axis in zip(moved, "xyz")]
        return point


class Topics:
    """The decoded messages of the topics."""

    def __init__(self, path):
        self.messages, self.schemas, seen = {}, {}, set()
        with open(path, "rb") as file:
            reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
            channels = reader.get_summary().channels.values()
            names = [channel.topic for channel in channels if channel.message_encoding == "protobuf"]
            for schema, channel, message, decoded in reader.iter_decoded_messages(topics=names):
                self.schemas[channel.topic] = schema.name
                if schema.name.startswith("foxglove."):
                    twin = official(schema.name)
                    same_fields(decoded.DESCRIPTOR, twin.DESCRIPTOR, seen)
                    decoded = twin.FromString(message.data)
                    check(len(UnknownFieldSet(decoded)) == 0, f"{channel.topic} has unknown fields")
                self.messages.setdefault(channel.topic, []).append((message.log_time, decoded))

    def of(self, schema):
        """Return the messages of a schema of Foxglove as plain values, with topic and time."""
        for topic, name in self.schemas.items():
            if name == f"foxglove.{schema}":
                for time, message in self.messages[topic]:
                    yield topic, time, message, MessageToDict(
                        message, preserving_proto_field_name=True, always_print_fields_with_no_presence=True
                    )


def stamp(message):
    """Return the time of a message, ns."""
    return message.timestamp.seconds * 1_000_000_000 + message.timestamp.nanos


def check_images(exact, topics):
    """Check the previews; return size and width of the recorded image by time."""
    shown = {}
    for topic, _, message, _ in topics.of("CompressedImage"):
        image = Image.open(io.BytesIO(message.data))
        image.load()
        check(image.format == "JPEG" and image.width <= MAX_WIDTH, f"{topic}: {image}")
        check(stamp(message) in exact.widths, f"{topic}: no image was recorded at {stamp(message)} ns")
        shown[stamp(message)] = (image.size, image.width / exact.widths[stamp(message)])
    if shown:
        seconds = (max(shown) - min(shown)) * 1e-9
        rate = (len(shown) - 1) / seconds
        check(2.5 < rate < IMAGES_PER_SECOND, f"{rate:.1f} images a second")
    for topic, _, message, _ in topics.of("CameraCalibration"):
        check((message.width, message.height) == shown[stamp(message)][0], f"{topic}: another size than the image")
        check(abs(message.K[2] * 2 - message.width) < 0.2 * message.width, f"{topic}: {list(message.K)}")
    return shown


def check_annotations(exact, topics, shown):
    """Check that annotations are the outputs that the recording holds; return their number."""
    count = 0
    for topic, time, message, plain in topics.of("ImageAnnotations"):
        value = exact.outputs[time].get(topic.removeprefix("/annotations/"))
        circles, lines = annotated(value, shown[stamp(message)][1] if shown else 1.0)
        found = [[one["position"]["x"], one["position"]["y"], one["diameter"]] for one in plain["circles"]]
        check(len(found) == len(circles) and all(map(is_close, found, circles)), f"{topic} at {time}: {found}, not {circles}")
        found = [[point[axis] for point in one["points"] for axis in "xy"] for one in plain["points"]]
        check(len(found) == len(lines) and all(map(is_close, found, lines)), f"{topic} at {time}: {found}, not {lines}")
        count += len(circles) + len(lines)
    return count


def check_frames(exact, topics, composed):
    """Check that transforms are the outputs that are places of frames, and that they compose to other outputs."""
    agreed = 0
    for topic, time, _, plain in topics.of("FrameTransforms"):
        # The first message, with which the tree of frames begins, comes before any output.
        frames, values = Frames(plain), exact.outputs.get(time, {}) if time < min(exact.outputs) else exact.outputs[time]
        for name, (_, _, info) in exact.infos.items():
            if info.get("child") is None or values.get(name) is None:
                continue
            frame, one = frames.places.get(info["child"], (None, None))
            check(frame == info["frame"], f"{topic} at {time}: {info['child']} is in {frame}")
            found = [[one["translation"][axis] for axis in "xyz"], [one["rotation"][axis] for axis in "xyzw"]]
            check(all(map(is_close, found, pose(values[name]))), f"{topic} at {time}: {found}, not {values[name]}")
        for frame, child, name in composed:
            expected, found = values.get(name), frames.place(child, [0.0, 0.0, 0.0], frame)
            if expected is not None and found is not None:
                check(is_close(found, pose(expected)[0], 1e-3), f"{child} in {frame} at {time}: {found}, not {expected}")
                agreed += 1
    check(agreed > 0 or not composed, "no frames were composed")


def check_projection(exact, topics, seen, place, radius):
    """Check that what is seen in images, projected by calibration and frames to the ground, is where the robot says."""
    if seen is None:
        return
    matrices = {stamp(message): message.K for _, _, message, _ in topics.of("CameraCalibration")}
    frames = {time: Frames(plain) for _, time, _, plain in topics.of("FrameTransforms")}
    errors = []
    for topic, time, message, plain in topics.of("ImageAnnotations"):
        expected = exact.outputs[time].get(place)
        if topic != f"/annotations/{seen}" or not plain["circles"] or expected is None:
            continue
        K, (optical,) = matrices[stamp(message)], [one for one in frames[time].places if one.endswith("_optical")]
        pixel = plain["circles"][0]["position"]
        ray = [(pixel["x"] - K[2]) / K[0], (pixel["y"] - K[5]) / K[4], 1.0]
        frame = exact.infos[place][2]["frame"]
        origin, end = (frames[time].place(optical, point, frame) for point in ([0.0, 0.0, 0.0], ray))
        along = (float(radius) - origin[2]) / (end[2] - origin[2])
        found = [origin[axis] + along * (end[axis] - origin[axis]) for axis in (0, 1)]
        errors.append(math.dist(found, (expected["x"], expected["y"])) / math.hypot(*found))
    check(len(errors) > 5, f"{seen} was seen {len(errors)} times")
    median = sorted(errors)[len(errors) // 2]
    check(median < 0.1, f"{seen} is {median:.0%} of its distance away from {place}")
    print(f"  {seen} projects to {place} with an error of {median:.1%} of the distance, {len(errors)} times")


def check_states(exact, topics):
    """Check states and parameters by name."""
    states = topics.messages["/states"]
    check([time for time, _ in states] == list(exact.trees), "states at other times than the tree")
    for time, message in states:
        for component, field in enumerate(message.DESCRIPTOR.fields):
            expected = exact.state(exact.trees[time], component)
            check(getattr(message, field.name) == expected, f"{field.name} at {time}: {getattr(message, field.name)}, not {expected}")
    _, message = topics.messages.get("/parameters", [(0, None)])[0]
    owners = [component for component in exact.components if component["params"]]
    for field, owner in zip(message.DESCRIPTOR.fields if message else [], owners, strict=True):
        found = getattr(message, field.name)
        for inner, param in zip(found.DESCRIPTOR.fields, owner["params"], strict=True):
            value = getattr(found, inner.name)
            check(value == param["value"], f"{owner['name']}.{param['name']}: {value}, not {param['value']}")


def check_rerun(path, topics):
    """Check that Rerun reads every message, as what it shows."""
    rows = {}
    for chunk in McapReader(path).stream():
        # The names of Foxglove's fields are ids of columns in others.
        for name in chunk.to_record_batch().schema.names:
            rows[chunk.entity_path, name] = rows.get((chunk.entity_path, name), 0) + chunk.num_rows
    for topic, schema in topics.schemas.items():
        found = rows.get((topic, RERUN[schema]), 0)
        check(found >= len(topics.messages[topic]), f"Rerun has {found} rows of {topic} as {RERUN[schema]}")


def main():
    """Read a file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("topics", nargs="+", help="topics that the file must have")
    parser.add_argument("--compose", nargs=3, action="append", default=[], metavar=("FRAME", "CHILD", "OUTPUT"))
    parser.add_argument("--project", nargs=3, default=(None, None, None), metavar=("SEEN", "PLACE", "RADIUS"))
    args = parser.parse_args()
    exact, topics = Exact(args.file), Topics(args.file)
    missing = [topic for topic in args.topics if topic not in topics.messages]
    check(not missing, f"no messages of {missing}, but of {sorted(topics.messages)}")
    shown = check_images(exact, topics)
    annotations = check_annotations(exact, topics, shown)
    check_frames(exact, topics, args.compose)
    check_projection(exact, topics, *args.project)
    check_states(exact, topics)
    check_rerun(args.file, topics)
    count = sum(map(len, topics.messages.values()))
    print(f"{args.file}: {len(topics.schemas)} topics, {count} messages, {len(shown)} images, {annotations} annotations are right")


main()
