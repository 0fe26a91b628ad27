"""A headless Chromium that is spoken to through a pipe by the DevTools protocol; nothing but Python's own library."""
import base64
import itertools
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

FLAGS = """--headless --no-sandbox --disable-gpu --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --disable-extensions --hide-scrollbars
--remote-debugging-pipe""".split()

# Of a PNG in base64: its width, its height, and red, green, blue and alpha of its points in base64.
PIXELS = """async png => {
  const file = new Blob([Uint8Array.from(atob(png), c => c.charCodeAt(0))], {type: 'image/png'});
  const image = await createImageBitmap(file, {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
  const context = new OffscreenCanvas(image.width, image.height).getContext('2d', {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  const {data} = context.getImageData(0, 0, image.width, image.height);
  let text = '';
  for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
  return [image.width, image.height, btoa(text)];
}"""


def find_chromium():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
    """One page. `events` are all that the browser told since the page was opened, as (method, parameters)."""

    def __init__(self, width=1200, height=800):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        their_in, self.out = os.pipe()
        self.into, their_out = os.pipe()

        def take_pipes():
            os.dup2(their_in, 13)  # first out of the way: 3 and 4 may be among the pipes themselves
            os.dup2(their_out, 14)
            os.dup2(13, 3)
            os.dup2(14, 4)

        command = [find_chromium(), *FLAGS, f"--window-size={width},{height}", f"--user-data-dir={self.profile.name}", "about:blank"]
        self.process = subprocess.Popen(command, close_fds=False, preexec_fn=take_pipes, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(their_in)
        os.close(their_out)
        self.numbers, self.buffer, self.events, self.session = itertools.count(1), b"", [], None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Network", "Log"]:
            self.call(f"{domain}.enable")

    def close(self):
        try:
            session, self.session = self.session, None
            self.call("Browser.close")
            self.process.wait(10)
        except (OSError, TimeoutError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.into)
        os.close(self.out)
        self.profile.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def receive(self, deadline):
        """The next message; None when there is none before the deadline."""
        while b"\0" not in self.buffer:
            if not select.select([self.into], [], [], max(0, deadline - time.monotonic()))[0]:
                return None
            data = os.read(self.into, 1 << 20)
            if not data:
                raise OSError("the browser ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, timeout=60, **parameters):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + timeout
        while (answer := self.receive(deadline)) is not None:
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append((answer["method"], answer.get("params", {})))
        raise TimeoutError(method)

    def wait_for(self, expression, timeout=60):
        """Until the expression is true in the page."""
        deadline = time.monotonic() + timeout
        while not self.value(expression):
            if time.monotonic() > deadline:
                raise TimeoutError(expression)
            time.sleep(0.05)

    def open(self, path, end=""):
        """Opens a file and waits until the page has drawn itself."""
        self.events.clear()
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=f"file://{path}{end}")
        self.wait_for("document.readyState === 'complete'")

    def value(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {json.dumps(result['exceptionDetails'])}")
        return result["result"].get("value")

    def press(self, key):
        for kind in ["keyDown", "keyUp"]:
            self.call("Input.dispatchKeyEvent", type=kind, key=key, text=key if kind == "keyDown" and len(key) == 1 else "")

    def click(self, x, y, count=1):
        for clicks in range(1, count + 1):
            for kind in ["mousePressed", "mouseReleased"]:
                self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=clicks)

    def picture(self):
        """What is seen, at half its size, as rows of (red, green, blue)."""
        width, height = self.value("[innerWidth, innerHeight]")
        clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": 0.5}
        return self.rows_of(self.call("Page.captureScreenshot", format="png", clip=clip)["data"])

    def rows_of(self, png):
        """The rows of a PNG, in base64 as DevTools gives it, as the browser decodes it: Python takes a second or two for one."""
        width, height, pixels = self.value(f"({PIXELS})('{png}')")
        line = 4 * width
        data = memoryview(base64.b64decode(pixels))
        rows = [data[row * line : (row + 1) * line] for row in range(height)]
        return [list(zip(row[0::4], row[1::4], row[2::4])) for row in rows]

    def resize(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def complaints(self):
        """Errors that were logged, and requests for anything but files and what the page holds itself."""
        found = []
        for method, event in self.events:
            if method == "Runtime.exceptionThrown":
                found.append(f"exception: {event['exceptionDetails']['text']}")
            if method == "Runtime.consoleAPICalled" and event["type"] in {"error", "assert"}:
                found.append(f"console: {event['args']}")
            if method == "Log.entryAdded" and event["entry"]["level"] == "error":
                found.append(f"log: {event['entry']['text']}")
            if method == "Network.requestWillBeSent" and not event["request"]["url"].startswith(("file:", "data:", "blob:", "about:")):
                found.append(f"request: {event['request']['url']}")
            if method == "Page.javascriptDialogOpening":
                found.append(f"dialog: {event['message']}")
        return found
