"""What a page holds (docs/reference/view-page.md), read from its text and put into it; and what it says."""
import base64
import json
import re
import zlib


def content_of(page, name):
    """The bytes of #toccata-header, #toccata-report or #toccata-data."""
    return zlib.decompress(base64.b64decode(re.search(rf'id="toccata-{name}"[^>]*>(.*?)</script>', page)[1]))


def with_content(page, name, value):
    """The page with another JSON value in an element."""
    written = base64.b64encode(zlib.compress(json.dumps(value).encode())).decode()
    return re.sub(rf'(id="toccata-{name}"[^>]*>).*?(</script>)', lambda m: m[1] + written + m[2], page)


def tells_depth(text, depth):
    """Whether the text says how deep, so that the bracket lies within what is said, and not much of it beside."""
    found = re.search(r"(?:([\d.e+-]+) to )?([\d.e+-]+)(?: [^ ]+)? deep", text)
    if not found:
        return False
    lower, upper, most = depth["lower"], depth["upper"], float(found[2])
    if found[1] is None:
        return abs(most - upper) <= 1e-5 * upper and abs(most - lower) <= 1e-5 * upper
    least, wider = float(found[1]), upper - lower + 2e-5 * upper
    return least <= lower * (1 + 2e-9) and upper * (1 - 2e-9) <= most and most - least <= 1.3 * wider
