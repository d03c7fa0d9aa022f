"""Units of formula arguments: every argument and result of a formula is annotated with one of these names.

A value may be a float or an array; the unit is always the coherent SI unit given here.
"""

from typing import Annotated, Any, TypeAlias

One: TypeAlias = Annotated[Any, "1"]
Metre: TypeAlias = Annotated[Any, "m"]
MetrePerRad: TypeAlias = Annotated[Any, "m/rad"]
SquareMetre: TypeAlias = Annotated[Any, "m2"]
Second: TypeAlias = Annotated[Any, "s"]
PerSecond: TypeAlias = Annotated[Any, "1/s"]
Hertz: TypeAlias = Annotated[Any, "Hz"]
MetrePerSecond: TypeAlias = Annotated[Any, "m/s"]
MetrePerSecond2: TypeAlias = Annotated[Any, "m/s2"]
MetrePerSecond3: TypeAlias = Annotated[Any, "m/s3"]
Rad: TypeAlias = Annotated[Any, "rad"]
RadPerSecond: TypeAlias = Annotated[Any, "rad/s"]
RadPerSecond2: TypeAlias = Annotated[Any, "rad/s2"]
RadPerSecond3: TypeAlias = Annotated[Any, "rad/s3"]
MetreRadPerSecond: TypeAlias = Annotated[Any, "m rad/s"]
Kilogram: TypeAlias = Annotated[Any, "kg"]
KilogramPerMetre: TypeAlias = Annotated[Any, "kg/m"]
KilogramPerMetre2: TypeAlias = Annotated[Any, "kg/m2"]
KilogramPerMetre3: TypeAlias = Annotated[Any, "kg/m3"]
KilogramMetre2: TypeAlias = Annotated[Any, "kg m2"]
Newton: TypeAlias = Annotated[Any, "N"]
NewtonPerKilogram: TypeAlias = Annotated[Any, "N/kg"]
NewtonPerMetre: TypeAlias = Annotated[Any, "N/m"]
NewtonSecondPerMetre: TypeAlias = Annotated[Any, "N s/m"]
NewtonMetre: TypeAlias = Annotated[Any, "N m"]
NewtonMetrePerRad: TypeAlias = Annotated[Any, "N m/rad"]
Pascal: TypeAlias = Annotated[Any, "Pa"]
Joule: TypeAlias = Annotated[Any, "J"]
Watt: TypeAlias = Annotated[Any, "W"]
Volt: TypeAlias = Annotated[Any, "V"]
Ampere: TypeAlias = Annotated[Any, "A"]
NewtonMetrePerAmpere: TypeAlias = Annotated[Any, "N m/A"]
