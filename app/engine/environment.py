"""Where the drive works: what is the same for every part of one calculation."""

from typing import Annotated, Literal

from app.engine.quantity import Declared, Option, Quantity
from app.engine.sheet import Sheet

RATED_AMBIENT = 313.15
"""Ambient temperature up to which a rating holds: 40 °C, IEC 60034-1 [K]"""
RATED_ALTITUDE = 1000.0
"""Altitude up to which a rating holds, IEC 60034-1 [m]"""


class Environment(Declared):
    """Gravity, surroundings and the model of the efficiency under regeneration."""

    gravity: Annotated[
        float,
        Quantity("m/s2", symbol="g", ge=0, le=30, default=9.81, source="standard gravity, rounded", about="gravity"),
    ]
    ambient_temperature: Annotated[
        float,
        Quantity(
            "degC",
            symbol="theta_amb",
            ge=233.15,
            le=373.15,
            default=RATED_AMBIENT,
            source="IEC 60034-1: rated up to 40 °C",
            about="ambient temperature",
        ),
    ]
    altitude: Annotated[
        float,
        Quantity(
            "m",
            symbol="h_alt",
            ge=0,
            le=6000,
            default=RATED_ALTITUDE,
            source="IEC 60034-1: rated up to 1000 m",
            about="altitude of the site",
        ),
    ]
    regeneration: Annotated[
        Literal["eta", "sew"],
        Option(
            default="eta",
            symbol="eta'",
            source="usual convention",
            about="efficiency while the load drives the motor",
            labels={"eta": "same efficiency: η", "sew": "SEW: η' = 2 − 1/η (self-locking at η ≤ 0.5)"},
        ),
    ]

    def check(self, sheet: Sheet) -> None:
        """Put on the sheet where the surroundings go beyond those that ratings are made for.

        Hot or thin air takes from what a motor and its drive may give. How much is a matter of each product that no
        catalogue row carries: so the check cannot be made, and says so.
        """
        rows = (
            ("ambient_temperature", "Ambient temperature", self.ambient_temperature, RATED_AMBIENT, "degC",
             "derating of motor and servo drive above 40 °C"),
            ("altitude", "Altitude of the site", self.altitude, RATED_ALTITUDE, "m",
             "derating of motor and servo drive above 1000 m"),
        )  # fmt: skip
        with sheet.section("Surroundings"):
            for key, name, value, rated, unit, missing in rows:
                if value > rated:
                    source = "IEC 60034-1: ratings hold up to 40 °C and 1000 m"
                    sheet.check(key, name, value, None, unit, source, missing=missing)
