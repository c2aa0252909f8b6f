#!/usr/bin/env python3
"""Writes the small inputs that the fuzzers of ray files and TM-33 start from, beside this script: rays/ and tm33/.
A TM-25 input leaves the header's 36000 bytes of texts out (fuzz_rays.cpp)."""
import math
import os
import struct

here = os.path.dirname(os.path.abspath(__file__))
nan = float("nan")
rays = [(1, 2, 3, 0, 0, -1, 4), (-1, 0, 0.5, 0.6, 0, -0.8, 2), (0, 0, 0, 0, 1, 0, 1)]


def write(folder, name, data):
    os.makedirs(os.path.join(here, folder), exist_ok=True)
    with open(os.path.join(here, folder, name), "wb") as out:
        out.write(data)


def tm25(columns, flags, luminous=nan, radiant=nan, spectral=0, wavelength=nan, tables=(), additional=0, text=b""):
    head = b"TM25" + struct.pack("<iiffQ", 2013, 0, luminous, radiant, len(rays)) + b"2026-01-01T00:00:00+00:00\0\0\0"
    head += struct.pack("<iifffiii", 0, spectral, wavelength, 380, 780, len(tables), additional, len(text))
    head = head.ljust(256, b"\0") + struct.pack("<8i", 1, 1, *flags)
    assert len(head) == 288
    spectra = b"".join(struct.pack("<i", len(t)) + b"".join(struct.pack("<ff", *pair) for pair in t) for t in tables)
    body = spectra.ljust((len(spectra) + 31) // 32 * 32, b"\0") + b"\0" * (512 * additional) + text
    for i, ray in enumerate(rays):
        row = list(ray[:6]) + columns(i, ray[6])
        body += struct.pack("<%df" % len(row), *row)
    return head + body


write("rays", "tm25_luminous", tm25(lambda i, f: [f], (0, 0, 1, 0, 0, 0), luminous=100))
write("rays", "tm25_wavelengths", tm25(lambda i, f: [f, 500 + 50 * i], (1, 1, 0, 0, 0, 0), radiant=2))
write("rays", "tm25_one_wavelength", tm25(lambda i, f: [f], (1, 0, 0, 0, 0, 0), spectral=1, wavelength=555))
write("rays", "tm25_one_spectrum", tm25(lambda i, f: [f], (1, 0, 0, 0, 0, 0), spectral=3,
                                        tables=[[(400, 0.1), (500, 1), (700, 0.4)]]))
write("rays", "tm25_spectra", tm25(lambda i, f: [f, i % 2], (1, 0, 0, 0, 0, 1), spectral=4,
                                   tables=[[(450, 1)], [(600, 1), (650, 0.5)]]))
write("rays", "tm25_all", tm25(lambda i, f: [1, 550, f, 0, 0, 0, 1, 0, 0, f, f, 0, 7], (1, 1, 1, 1, 1, 1), spectral=4,
                               tables=[[(450, 1)]], additional=1, text=b"t\0\0\0" * 8))
write("rays", "tm25_header_alone", tm25(lambda i, f: [f], (1, 0, 0, 0, 0, 0), luminous=3))


def zemax(unit, ray_format, flux_type, wavelength_um):
    head = struct.pack("<II", 1010, len(rays)) + b"a lamp".ljust(100, b"\0") + struct.pack("<3f", 7, 7, wavelength_um)
    head = head.ljust(136, b"\0") + struct.pack("<I", unit)
    head = head.ljust(192, b"\0") + struct.pack("<4i", ray_format, flux_type, 0, 0)
    extra = [0.55] if ray_format == 2 else []
    return head + b"".join(struct.pack("<%df" % (7 + len(extra)), *ray, *extra) for ray in rays)


write("rays", "zemax_lumens", zemax(4, 0, 1, 0))
write("rays", "zemax_watts", zemax(1, 0, 0, 0.6))
write("rays", "zemax_spectral", zemax(0, 2, 0, 0))


def lighttools(data_type, colour, unit, total, version=2):
    head = b"LTRF" + struct.pack("<6I4f", version, 0, data_type, 0, colour, unit, 0, 0, 0, total)
    head += struct.pack("<I", 0) if version == 3 else b""
    extra = [555] if colour == 2 else []
    return head + b"".join(struct.pack("<%df" % (7 + len(extra)), *ray, *extra) for ray in rays) + b"LTRFEND"


write("rays", "lighttools_lumens", lighttools(1, 0, 1, 0))
write("rays", "lighttools_watts", lighttools(0, 2, 3, 2))
write("rays", "lighttools_3", lighttools(1, 2, 0, 9, 3))


def values(h, v, name="IntData", attributes=("h", "v")):
    out = []
    for a in h:
        for b in v:
            cd = 500 * (1 + math.cos(math.radians(b))) * (1 + 0.2 * math.cos(math.radians(a)))
            out.append('<%s %s="%g" %s="%g">%.6g</%s>' % (name, attributes[0], a, attributes[1], b, cd, name))
    return "\n".join(out)


def tm33(emitters, luminaire="", equipment=""):
    return ("""<?xml version="1.0" encoding="UTF-8"?>
<IESTM33-22><Version>1.1</Version>
<Header><Manufacturer>M &amp; N</Manufacturer><CatalogNumber>1</CatalogNumber><Description>d</Description>
<Laboratory>l</Laboratory><ReportNumber>r</ReportNumber><ReportDate>2026-01-01</ReportDate></Header>
%s%s%s</IESTM33-22>
""" % (luminaire, equipment, emitters)).encode()


def emitter(intensity, more="", areas=""):
    return ("<Emitter><Quantity>1</Quantity><Description>LED</Description>%s<LuminousData><LuminousIntensity>%s"
            "</LuminousIntensity></LuminousData>%s</Emitter>\n" % (more, intensity, areas))


low = [0, 45, 90, 180]
bottom = ("<EmissionAreas><BottomFace><NumberBottom>1</NumberBottom><BottomArea><Length>1.2</Length><Width>0.3</Width>"
          "<LengthOffset>0</LengthOffset><WidthOffset>0</WidthOffset><Circular>false</Circular></BottomArea>"
          "</BottomFace><C0Face><C0Area><Length>1.2</Length><Height>0.1</Height></C0Area></C0Face></EmissionAreas>")
write("tm33", "full.xml", tm33(emitter("<Symm>Symm_Full</Symm>" + values([0], low))))
write("tm33", "none.xml", tm33(emitter("<Symm>Symm_None</Symm><NumberMeasured>16</NumberMeasured>"
                                       "<NumberHorz>4</NumberHorz><NumberVert>4</NumberVert>" +
                                       values([0, 90, 180, 270], low), areas=bottom)))
write("tm33", "bi_0.xml", tm33(emitter("<Symm>Symm _ Bi _ 0</Symm>" + values([0, 90, 180], low))))
write("tm33", "bi_90.xml", tm33(emitter("<Symm>Symm_Bi_90</Symm>" + values([90, 180, 270], low))))
write("tm33", "quad.xml", tm33(emitter("<Symm>Symm_Quad</Symm>" + values([0, 30, 90], low))))
write("tm33", "relative.xml", tm33(emitter("<AbsolutePhotometry>false</AbsolutePhotometry><Multiplier>2</Multiplier>" +
                                       values([0], low),
                                       "<RatedLumens>2000</RatedLumens><InputWattage>20</InputWattage>"
                                       "<BallastFactor>0.9</BallastFactor>"
                                       "<ColorTemperature><FixedCCT>3000</FixedCCT></ColorTemperature>")))
write("tm33", "two.xml", tm33(emitter(values([0, 180], [0, 90])) + emitter(values([0], [90, 135, 180]))))
write("tm33", "type_b.xml", tm33(emitter(values([-90, 0, 90], [-90, 0, 90])), equipment="<Equipment><Gonioradiometer>"
                                 "<Type>IES_B</Type></Gonioradiometer></Equipment>"))
write("tm33", "of_2018.xml", b"\xef\xbb\xbf<!DOCTYPE x [<!ENTITY y 'z'>]><!-- c -->"
      b"<t:LuminaireOpticalData version='1.0'>"
      b"<Luminaire><LuminousOpening><Shape>Circular</Shape><Diameter>0.2</Diameter></LuminousOpening></Luminaire>"
      b"<Emitter><IntensityDistribution><PhotometryType>C</PhotometryType><Metric>Luminous</Metric>"
      b"<Units><![CDATA[cd/klm]]></Units>"
      + values([0], low, "IntensityData", ("horz", "vert")).encode() +
      b"</IntensityDistribution><RatedLumens>800</RatedLumens></Emitter></t:LuminaireOpticalData>")
