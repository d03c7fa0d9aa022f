"""Names that survive a reload: slugs of makers, editions and order codes, and the product ids made of them."""

import hashlib
import re
import unicodedata

MAX_SLUG = 120


def slugify(text: str) -> str:
    """Small ASCII letters and digits, everything else a hyphen; never empty.

    >>> [slugify(text) for text in ("Breco/Contitech (SYNCHROFLEX)", "DT71D8/2 /BM", "TR 080 1_3,5")]
    ['breco-contitech-synchroflex', 'dt71d8-2-bm', 'tr-080-1-3-5']
    """
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    slug = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")
    return slug[:MAX_SLUG].rstrip("-") or short_hash(text)


def short_hash(text: str) -> str:
    """Eight characters that tell apart texts whose slugs are the same."""
    return hashlib.sha256(text.encode()).hexdigest()[:8]


def product_id(table: str, edition_key: str, slug: str) -> str:
    """Stable id of a product: table, maker, edition and order code.

    >>> product_id("servo_motor", "lafert:brushless-2008", "b5602i-300")
    'servo-motor:lafert:brushless-2008:b5602i-300'
    """
    return f"{table.replace('_', '-')}:{edition_key}:{slug}"
