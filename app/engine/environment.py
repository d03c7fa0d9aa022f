"""Where the drive works: what is the same for every part of one calculation."""

from typing import Annotated, Literal

from app.engine.quantity import Declared, Option, Quantity


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
            default=313.15,
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
            default=1000.0,
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
