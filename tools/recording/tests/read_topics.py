"""Checks the topics for other programs in a recording, with the libraries of those who read them.

The file is a bag for `rosbags`, its definitions are those of ROS, and each message is decoded by them, and by Rerun. Images,
annotations, frames, states and parameters are compared with the exact values in the same file.
"""

import argparse
import io
import math
import re
import sys
from pathlib import Path

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from PIL import Image
from rerun.chunk import McapReader
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from bica.recording.file import RecordingFile
from bica.recording.postcard import decoder

#: Component that Rerun makes of a message; of others it shows the fields.
RERUN = {
    "sensor_msgs/msg/CompressedImage": "EncodedImage:blob",
    "sensor_msgs/msg/CameraInfo": "Pinhole:image_from_camera",
    "tf2_msgs/msg/TFMessage": "Transform3D:translation",
    "sensor_msgs/msg/PointCloud2": "Points3D:positions",
    "rcl_interfaces/msg/Log": "TextLog:text",
    "std_msgs/msg/String": "TextDocument:text",
    "geometry_msgs/msg/PoseStamped": "InstancePoses3D:translations",
    "sensor_msgs/msg/JointState": "CoordinateFrame:frame",
    "sensor_msgs/msg/Imu": "Scalars:scalars",
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


def snake(name):
    """Return a name in the form of ROS."""
    return re.sub(r"[^A-Za-z0-9]+", "_", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name)).strip("_").lower()


class Exact:
    """The exact values of a recording."""

    def __init__(self, path):
        self.file = RecordingFile(path)
        self.components = self.file.header["tree"]["components"]
        self.infos = {
            f"{owner['name']}/{info['name']}": (component, index, info)
            for component, owner in enumerate(self.components)
            for index, info in enumerate(owner["info"])
        }
        self.outputs = dict(self._outputs())
        self.trees = dict(self._records("tree"))
        self.widths = {time: self._width(blob) for time, blob in self._records("blobs")}
        places = [info for owner in self.components for info in owner["info"] if info.get("child")]
        above = {info["frame"]: "map" for info in places if info["child"] == "odometry"}
        self.frames = {"robot": "base_link", "odometry": "odom"} | above

    def frame(self, name):
        """Return the name of a frame in ROS."""
        return self.frames.get(name, snake(name))

    def topic(self, output):
        """Return the topic of an output `Component/output`."""
        return "/".join(["", snake(self.file.header["tree"]["name"]), *map(snake, output.split("/"))])

    def _records(self, channel):
        if schema := self.file.schema(channel):
            decode = decoder(schema)
            for time, content in self.file.contents(channel):
                yield time, decode(content)

    @staticmethod
    def _width(blob):
        return next(iter(blob["format"].values())).get("width") if isinstance(blob["format"], dict) else None

    def _outputs(self):
        schemas = [[output.get("schema") for output in owner["info"]] for owner in self.components]
        decoders = [[schema and decoder(schema) for schema in owner] for owner in schemas]
        for time, record in self._records("information"):
            values = {}
            for one in record["values"]:
                component, index = one["component"], one["index"]
                name = f"{self.components[component]['name']}/{self.components[component]['info'][index]['name']}"
                values[name] = decoders[component][index](one["value"]) if one["value"] else None
            yield time, values

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


def axes(value, names="xyz"):
    """Return the coordinates of a vector or quaternion."""
    return [getattr(value, axis) for axis in names]


class Frames:
    """The newest places of frames."""

    def __init__(self, fixed):
        self.places = {}
        for message in fixed:
            self.add(message)

    def add(self, message):
        """Take in a message."""
        self.places |= {one.child_frame_id: (one.header.frame_id, one.transform) for one in message.transforms}

    def place(self, frame, point, within):
        """Return a point of a frame in another frame; None if the frame is not in it."""
        while frame != within:
            if frame not in self.places:
                return None
            frame, one = self.places[frame]
            moved = rotate(axes(one.rotation, "xyzw"), point)
            point = [a + b for a, b in zip(moved, axes(one.translation))]
        return point


class Topics:
    """The decoded messages of the topics."""

    def __init__(self, path):
        self.messages, self.schemas = {}, {}
        with open(path, "rb") as file:
            reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
            for schema, channel, message, decoded in reader.iter_decoded_messages():
                if not channel.topic.startswith("/bica/"):
                    self.schemas[channel.topic] = schema.name
                    self.messages.setdefault(channel.topic, []).append((message.log_time, decoded))

    def of(self, schema):
        """Return the messages of a type, with topic and time."""
        for topic, name in self.schemas.items():
            if name == schema:
                for time, message in self.messages[topic]:
                    yield topic, time, message


def stamp(time):
    """Return a time, ns."""
    return time.sec * 1_000_000_000 + time.nanosec


def check_bag(path):
    """Check that `rosbags` reads each message, and that what the file says of a type is what ROS says of it."""
    known, counts = get_typestore(Stores.ROS2_JAZZY), {}
    with Reader(Path(path)) as reader:
        for connection in reader.connections:
            own = get_types_from_msg(connection.msgdef.data, connection.msgtype)
            for name, (_, fields) in own.items():
                # The arrays of definitions have a length, or none: they are equal as they are.
                check(name not in known.fielddefs or fields == known.fielddefs[name][1], f"{name} is not the one of ROS: {fields}")
            known.register({name: fields for name, fields in own.items() if name not in known.fielddefs})
            latched = connection.ext.offered_qos_profiles[0].durability.name == "TRANSIENT_LOCAL"
            is_once = connection.topic in ("/tf_static", "/rosout") or connection.topic.endswith(("/scenery", "/states"))
            check(latched or not is_once, f"{connection.topic} is not kept for nodes that come later")
        for connection, _, raw in reader.messages():
            known.deserialize_cdr(raw, connection.msgtype)
            counts[connection.topic] = counts.get(connection.topic, 0) + 1
    return sum(counts.values())


def check_images(exact, topics):
    """Check the previews; return size and width of the recorded image by time."""
    shown = {}
    for topic, _, message in topics.of("sensor_msgs/msg/CompressedImage"):
        image, time = Image.open(io.BytesIO(message.data)), stamp(message.header.stamp)
        image.load()
        check(image.format == "JPEG" and image.width <= MAX_WIDTH, f"{topic}: {image}")
        check(time in exact.widths, f"{topic}: no image was recorded at {time} ns")
        shown[time] = (image.size, image.width / exact.widths[time])
    if shown:
        seconds = (max(shown) - min(shown)) * 1e-9
        rate = (len(shown) - 1) / seconds
        check(2.5 < rate < IMAGES_PER_SECOND, f"{rate:.1f} images a second")
    for topic, _, message in topics.of("sensor_msgs/msg/CameraInfo"):
        size = shown[stamp(message.header.stamp)][0]
        check((message.width, message.height) == size, f"{topic}: another size than the image")
        check(abs(message.k[2] * 2 - message.width) < 0.2 * message.width, f"{topic}: {list(message.k)}")
    return shown


def check_annotations(exact, topics, shown):
    """Check that annotations are the outputs that the recording holds; return their number."""
    count, names = 0, {exact.topic(name): name for name in exact.infos}
    for topic, time, message in topics.of("foxglove_msgs/msg/ImageAnnotations"):
        value = exact.outputs[time].get(names[topic])
        circles, lines = annotated(value, shown[stamp(message.timestamp)][1] if shown else 1.0)
        found = [[one.position.x, one.position.y, one.diameter] for one in message.circles]
        check(len(found) == len(circles) and all(map(is_close, found, circles)), f"{topic} at {time}: {found}, not {circles}")
        found = [[part for point in one.points for part in axes(point, "xy")] for one in message.points]
        check(len(found) == len(lines) and all(map(is_close, found, lines)), f"{topic} at {time}: {found}, not {lines}")
        count += len(circles) + len(lines)
    return count


def placed(topics):
    """Return the places of frames after each time."""
    messages = topics.messages.get("/tf", [])
    frames = Frames(message for _, message in topics.messages.get("/tf_static", []))
    for number, (time, message) in enumerate(messages):
        frames.add(message)
        if number + 1 == len(messages) or messages[number + 1][0] != time:
            yield time, frames


def check_frames(exact, topics, composed):
    """Check that transforms are the outputs that are places of frames, and that they compose to other outputs."""
    agreed = 0
    for number, (time, frames) in enumerate(placed(topics)):
        # The first message, with which the tree of frames begins, comes before any output.
        values = exact.outputs.get(time, {})
        check(number == 0 or values, f"no outputs at {time}")
        roots = {parent for parent, _ in frames.places.values()} - frames.places.keys()
        check(len(roots) == 1, f"the frames have the roots {sorted(roots)} at {time}")
        for name, (_, _, info) in exact.infos.items():
            if info.get("child") is None or values.get(name) is None:
                continue
            frame, one = frames.places.get(exact.frame(info["child"]), (None, None))
            check(frame == exact.frame(info["frame"]), f"{info['child']} is in {frame} at {time}")
            found = [axes(one.translation), axes(one.rotation, "xyzw")]
            check(all(map(is_close, found, pose(values[name]))), f"{name} at {time}: {found}, not {values[name]}")
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
    matrices = {stamp(message.header.stamp): message.k for _, _, message in topics.of("sensor_msgs/msg/CameraInfo")}
    seen_at = {time: message for time, message in topics.messages[exact.topic(seen)]}
    errors = []
    for time, frames in placed(topics):
        message, expected = seen_at.get(time), exact.outputs.get(time, {}).get(place)
        if message is None or not message.circles or expected is None:
            continue
        k, (optical,) = matrices[stamp(message.timestamp)], [one for one in frames.places if one.endswith("_optical")]
        pixel = message.circles[0].position
        ray = [(pixel.x - k[2]) / k[0], (pixel.y - k[5]) / k[4], 1.0]
        frame = exact.frame(exact.infos[place][2]["frame"])
        origin, end = (frames.place(optical, point, frame) for point in ([0.0, 0.0, 0.0], ray))
        along = (float(radius) - origin[2]) / (end[2] - origin[2])
        found = [origin[axis] + along * (end[axis] - origin[axis]) for axis in (0, 1)]
        errors.append(math.dist(found, (expected["x"], expected["y"])) / math.hypot(*found))
    check(len(errors) > 5, f"{seen} was seen {len(errors)} times")
    median = sorted(errors)[len(errors) // 2]
    check(median < 0.1, f"{seen} is {median:.0%} of its distance away from {place}")
    print(f"  {seen} projects to {place} with an error of {median:.1%} of the distance, {len(errors)} times")


def check_states(exact, topics):
    """Check states and parameters by name."""
    for time, message in topics.messages[exact.topic("states")]:
        found = {one.key: one.value for one in message.values}
        expected = {owner["name"]: exact.state(exact.trees[time], index) for index, owner in enumerate(exact.components)}
        check(found == expected, f"states at {time}: {found}, not {expected}")
    expected = {f"{owner['name']}.{param['name']}": param["value"] for owner in exact.components for param in owner["params"]}
    events = topics.messages.get("/parameter_events", [])
    check(bool(events) == bool(expected), f"{len(events)} events of {len(expected)} parameters")
    for one in events[0][1].changed_parameters if events else []:
        value = [one.value.bool_value, one.value.integer_value, one.value.double_value, one.value.string_value][one.value.type - 1]
        check(value == expected[one.name], f"{one.name}: {value}, not {expected[one.name]}")


def check_rerun(path, topics):
    """Check that Rerun reads every message, as what it shows."""
    rows = {}
    for chunk in McapReader(path).stream():
        # The names of fields are ids of columns in others.
        for name in chunk.to_record_batch().schema.names:
            rows[chunk.entity_path, name] = rows.get((chunk.entity_path, name), 0) + chunk.num_rows
    for topic, schema in topics.schemas.items():
        component = RERUN.get(schema, schema.replace("/", ".") + ":message")
        found = rows.get((topic, component), 0)
        check(found >= len(topics.messages[topic]), f"Rerun has {found} rows of {topic} as {component}")


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
    count = check_bag(args.file)
    print(f"{args.file}: {len(topics.schemas)} topics, {count} messages, {len(shown)} images, {annotations} annotations are right")


main()
