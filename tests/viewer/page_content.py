"""What a page holds (docs/reference/view-page.md), read from its text and put into it."""
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
