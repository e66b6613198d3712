"""modelDescription.xml of a unit."""

from __future__ import annotations

import re
from collections.abc import Sequence
from xml.etree import ElementTree

from dampen.export.fmu.variables import FIXED, INPUT, LARGEST, OUTPUT, TUNABLE, Variable
from dampen.release import version

# exponents of kg, m, s, rad; what is not here has a name only
BASE_UNITS = {
    "1": {},
    "s": {"s": 1},
    "m": {"m": 1},
    "rad": {"rad": 1},
    "m/s": {"m": 1, "s": -1},
    "rad/s": {"rad": 1, "s": -1},
    "m/s2": {"m": 1, "s": -2},
    "N": {"kg": 1, "m": 1, "s": -2},
    "N.m": {"kg": 1, "m": 2, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "N/m": {"kg": 1, "s": -2},
    "N.m/rad": {"kg": 1, "m": 2, "s": -2, "rad": -1},
    "N.s/m": {"kg": 1, "s": -1},
    "N.m.s/rad": {"kg": 1, "m": 2, "s": -1, "rad": -1},
    "m/(N.s)": {"kg": -1, "s": 1},
    "rad/(N.m.s)": {"kg": -1, "m": -2, "s": 1, "rad": 1},
    "N/s": {"kg": 1, "m": 1, "s": -3},
}
NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # what no XML may have, even escaped
CAUSALITY = {INPUT: "input", OUTPUT: "output", FIXED: "parameter", TUNABLE: "parameter"}
VARIABILITY = {FIXED: "fixed", TUNABLE: "tunable"}


def model_description(
    identifier: str, name: str, guid: str, about: str, variables: Sequence[Variable], sources: Sequence[str],
    step: float, stop: float,
) -> bytes:  # fmt: skip
    """The description.

    identifier: of the binary.   about: what it is, and how it is to be used.   step, stop: of the default experiment [s].
    """
    root = ElementTree.Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=name,
        guid=guid,
        description=about,
        generationTool=f"dampen {version()}",
        variableNamingConvention="flat",
    )
    unit = ElementTree.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=identifier,
        canHandleVariableCommunicationStepSize="true",
        canNotUseMemoryManagementFunctions="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
    )
    files = ElementTree.SubElement(unit, "SourceFiles")
    for source in sources:
        ElementTree.SubElement(files, "File", name=source)
    add_units(root, variables)
    categories = ElementTree.SubElement(root, "LogCategories")
    for category in ("logStatusWarning", "logStatusError"):
        ElementTree.SubElement(categories, "Category", name=category)
    ElementTree.SubElement(root, "DefaultExperiment", startTime="0", stopTime=repr(stop), stepSize=repr(step))
    add_variables(root, variables)
    add_structure(root, variables)
    for element in root.iter():
        element.attrib.update({name: NOT_XML.sub("\N{REPLACEMENT CHARACTER}", text) for name, text in element.attrib.items()})
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)


def add_units(root: ElementTree.Element, variables: Sequence[Variable]) -> None:
    """The units that occur."""
    definitions = ElementTree.SubElement(root, "UnitDefinitions")
    for name in sorted({v.unit for v in variables if v.unit}):
        unit = ElementTree.SubElement(definitions, "Unit", name=name)
        if name in BASE_UNITS:
            ElementTree.SubElement(unit, "BaseUnit", {base: str(power) for base, power in BASE_UNITS[name].items()})


def add_variables(root: ElementTree.Element, variables: Sequence[Variable]) -> None:
    """The variables; value references count numbers and whole numbers apart."""
    given = ElementTree.SubElement(root, "ModelVariables")
    counts = {False: 0, True: 0}
    for v in variables:
        scalar = ElementTree.SubElement(
            given,
            "ScalarVariable",
            name=v.name,
            valueReference=str(counts[v.whole]),
            description=v.meaning,
            causality=CAUSALITY.get(v.role, "local"),
            variability=VARIABILITY.get(v.role, "discrete"),
            initial="calculated" if v.start is None else "exact",
        )
        counts[v.whole] += 1
        if v.role == INPUT:
            del scalar.attrib["initial"]
        about = {"unit": v.unit} if v.unit else {}
        about |= {"start": repr(v.start)} if v.start is not None else {}
        about |= {"min": repr(v.least)} if v.least > -LARGEST else {}
        about |= {"max": repr(v.most)} if v.most < LARGEST else {}
        ElementTree.SubElement(scalar, "Integer" if v.whole else "Real", about)


def add_structure(root: ElementTree.Element, variables: Sequence[Variable]) -> None:
    """What depends on what: inputs are held over a communication step, and outputs depend on none at its end, nor at the
    start; there what is seen of a plant depends on how its parameters are set."""
    structure = ElementTree.SubElement(root, "ModelStructure")
    given = [str(index) for index, v in enumerate(variables, 1) if v.role in (FIXED, TUNABLE) and v.at.startswith("plant.")]
    for name in ("Outputs", "InitialUnknowns"):
        listed = ElementTree.SubElement(structure, name)
        for index, v in enumerate(variables, 1):
            if v.role == OUTPUT:
                known = given if name == "InitialUnknowns" and v.at.startswith("plant.") else []
                ElementTree.SubElement(listed, "Unknown", index=str(index), dependencies=" ".join(known))
