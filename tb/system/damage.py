# SPDX-License-Identifier: MIT
"""damage.py - damaged files of each format, made of small sound ones."""
import io
import struct
import zipfile
import zlib

CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
         (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
BOMB = 2 ** 30 + 2 ** 20
DEEP = 100000
LAUGHS = "<!DOCTYPE x [<!ENTITY a0 'ha'>" + "".join(
    f"<!ENTITY a{n + 1} '{f'&a{n};' * 10}'>" for n in range(10)) + "]>"


def replaced(text, old, new):
    """The text with its first `old` replaced, which must be there."""
    assert old in text, old
    return text.replace(old, new, 1)


# ------------------------------------------------------------------------ STL

def stl_text():
    """The cube."""
    lines = ["solid cube"]
    for face in FACES:
        lines += ["facet normal 0 0 1", "outer loop",
                  *(f"vertex {' '.join(map(str, CUBE[c]))}" for c in face), "endloop", "endfacet"]
    return "\n".join(lines + ["endsolid cube", ""])


def stl_binary(count=12, first=0.0):
    """The cube, with a count and a first coordinate."""
    data = b"cube".ljust(80, b"\0") + struct.pack("<I", count)
    for n, face in enumerate(FACES):
        corners = [float(x) for c in face for x in CUBE[c]]
        if n == 0:
            corners[0] = first
        data += struct.pack("<12fH", 0, 0, 1, *corners, 0)
    return data


def stl():
    """Damaged STL files."""
    text, binary = stl_text(), stl_binary()
    yield "empty.stl", b""
    yield "blank.stl", b"  \n\n"
    yield "head-cut.stl", b"sol"
    yield "cut.stl", text[:len(text) // 2]
    yield "no-facets.stl", "solid a\nendsolid a\n"
    for word in "nan", "inf", "1e400", "0,5", "x", "0x1p3":
        yield f"vertex-{word}.stl", replaced(text, "vertex 0 0 0", f"vertex 0 {word} 0")
    yield "vertex-short.stl", replaced(text, "vertex 0 0 0", "vertex 0 0")
    yield "keyword.stl", replaced(text, "outer loop", "outer lo\xf6p").encode("latin-1")
    yield "utf16.stl", text.encode("utf-16")
    yield "garbage.stl", bytes(n * n * 37 % 251 for n in range(5000))
    yield "binary-head-cut.stl", binary[:82]
    yield "binary-cut.stl", binary[:300]
    yield "binary-count-more.stl", stl_binary(13)
    yield "binary-count-less.stl", stl_binary(11)
    yield "binary-count-most.stl", stl_binary(2 ** 32 - 1)
    yield "binary-nan.stl", stl_binary(first=float("nan"))
    yield "binary-inf.stl", stl_binary(first=float("-inf"))


# ------------------------------------------------------------------------ OBJ

def obj():
    """Damaged OBJ files."""
    vertices = "".join(f"v {x} {y} {z}\n" for x, y, z in CUBE)
    text = vertices + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)
    yield "empty.obj", b""
    yield "no-faces.obj", vertices
    for index in "0", "9", "-9", "99999999999999999999", "1.5", "/1", "1/x", "1/1/1/1", "a", "1//x":
        yield f"index-{index.replace('/', '_')}.obj", replaced(text, "f 1 3 4", f"f {index} 3 4")
    for word in "nan", "inf", "1e400", "0,5", "x":
        yield f"vertex-{word}.obj", replaced(text, "v 0 0 0", f"v 0 {word} 0")
    yield "vertex-short.obj", replaced(text, "v 0 0 0", "v 0 0")
    yield "face-short.obj", replaced(text, "f 1 3 4", "f 1 3")
    yield "surface.obj", text + "cstype bezier\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nend\n"
    yield "keyword.obj", text + "fx 1 2 3\n"
    yield "latin.obj", text.encode() + b"\xf6\xe4 1 2 3\n"
    yield "zero-byte.obj", replaced(text, "f 1 3 4", "f 1 3 \0").encode()
    yield "utf16.obj", text.encode("utf-16")
    yield "continued.obj", text + "f 1 2 \\"
    yield "garbage.obj", bytes(n * n * 37 % 251 for n in range(5000))


# ------------------------------------------------------------------------ PLY

def ply_head(form="ascii", vertices=8, faces=12, kind="float", counts="uchar", indices="int"):
    """A head of a PLY file."""
    return (f"ply\nformat {form} 1.0\nelement vertex {vertices}\nproperty {kind} x\n"
            f"property {kind} y\nproperty {kind} z\nelement face {faces}\n"
            f"property list {counts} {indices} vertex_indices\nend_header\n")


def ply_body(order):
    """The binary rows behind it."""
    return b"".join(struct.pack(order + "3f", *v) for v in CUBE) + \
        b"".join(struct.pack(order + "B3i", 3, *face) for face in FACES)


def ply():
    """Damaged PLY files."""
    rows = "".join(f"{x} {y} {z}\n" for x, y, z in CUBE)
    faces = "".join(f"3 {a} {b} {c}\n" for a, b, c in FACES)
    text = ply_head() + rows + faces
    yield "empty.ply", b""
    yield "head-cut.ply", text[:60]
    yield "head-no-end.ply", replaced(text, "end_header\n", "")
    yield "head-format.ply", replaced(text, "ascii", "ebcdic")
    yield "head-version.ply", replaced(text, "ascii 1.0", "ascii 7.0")
    yield "head-type.ply", replaced(text, "float x", "quad x")
    yield "head-twice.ply", replaced(text, "float y", "float x")
    yield "head-no-z.ply", replaced(text, "float z", "float w")
    yield "head-negative.ply", replaced(text, "face 12", "face -12")
    yield "head-most.ply", replaced(text, "face 12", "face 1000000000000000000000000000000")
    yield "head-keyword.ply", replaced(text, "element face", "elements face")
    yield "billion-faces.ply", replaced(text, "face 12", "face 1000000000")
    yield "billion-vertices.ply", replaced(text, "vertex 8", "vertex 1000000000")
    yield "faces-more.ply", replaced(text, "face 12", "face 13")
    yield "faces-less.ply", replaced(text, "face 12", "face 11")
    yield "cut.ply", text[:-30]
    yield "index-8.ply", replaced(text, "3 0 2 3", "3 0 2 8")
    yield "index-minus.ply", replaced(text, "3 0 2 3", "3 0 2 -1")
    yield "index-nan.ply", replaced(text, "3 0 2 3", "3 0 2 nan")
    yield "list-long.ply", replaced(text, "3 0 2 3", "255 0 2 3")
    yield "list-two.ply", replaced(text, "3 0 2 3", "2 0 2")
    for word in "nan", "inf", "1e400", "x":
        yield f"vertex-{word}.ply", replaced(text, "0 0 0\n", f"0 {word} 0\n")
    yield "utf16.ply", text.encode("utf-16")
    for form, order in ("binary_little_endian", "<"), ("binary_big_endian", ">"):
        name = form.split("_")[1]
        body = ply_body(order)
        yield f"{name}-cut.ply", ply_head(form).encode() + body[:-7]
        yield f"{name}-more.ply", ply_head(form).encode() + body + b"\1\2\3"
        yield f"{name}-billion.ply", ply_head(form, faces=10 ** 9).encode() + body
        yield f"{name}-vertices.ply", ply_head(form, vertices=2 ** 63).encode() + body
        yield f"{name}-nan.ply", ply_head(form).encode() + struct.pack(
            order + "f", float("nan")) + body[4:]
        yield f"{name}-list.ply", ply_head(form, counts="uint").encode() + body[:96] + \
            struct.pack(order + "I", 2 ** 32 - 1) + body[97:]


# ------------------------------------------------------------------------ DAE

def dae_text(library="", scene="<node id='n'><instance_geometry url='#g'/></node>", head=""):
    """A cube in a scene."""
    numbers = " ".join(str(x) for v in CUBE for x in v)
    corners = " ".join(str(c) for face in FACES for c in face)
    return (f"<?xml version='1.0'?>{head}<COLLADA "
            "xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
            "<unit name='meter' meter='1'/><up_axis>Z_UP</up_axis></asset><library_geometries>"
            "<geometry id='g'><mesh><source id='p'><float_array id='a' count='24'>"
            f"{numbers}</float_array><technique_common><accessor source='#a' count='8' "
            "stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
            "<param name='Z' type='float'/></accessor></technique_common></source>"
            "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
            "<triangles count='12'><input semantic='VERTEX' source='#v' offset='0'/>"
            f"<p>{corners}</p></triangles></mesh></geometry></library_geometries>{library}"
            f"<library_visual_scenes><visual_scene id='s'>{scene}</visual_scene>"
            "</library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>")


def dae():
    """Damaged DAE files."""
    text = dae_text()
    yield "empty.dae", b""
    yield "head-cut.dae", text[:40]
    yield "cut.dae", text[:len(text) // 2]
    yield "tags.dae", replaced(text, "</mesh>", "</mash>")
    yield "version.dae", replaced(text, "version='1.4.1'", "version='9.0'")
    yield "root.dae", "<?xml version='1.0'?><robot name='r'/>"
    yield "laughs.dae", dae_text(scene="<node>&a9;<instance_geometry url='#g'/></node>",
                                 head=replaced(LAUGHS, "DOCTYPE x", "DOCTYPE COLLADA"))
    yield "entity.dae", dae_text(scene="<node>&e;<instance_geometry url='#g'/></node>",
                                 head="<!DOCTYPE COLLADA [<!ENTITY e SYSTEM '/etc/passwd'>]>")
    yield "deep.dae", dae_text(scene="<node>" * DEEP + "<instance_geometry url='#g'/>" +
                               "</node>" * DEEP)
    yield "billion.dae", replaced(text, "<triangles count='12'", "<triangles count='1000000000'")
    yield "array-billion.dae", replaced(text, "count='24'", "count='1000000000'")
    yield "accessor-billion.dae", replaced(text, "count='8'", "count='1000000000'")
    yield "array-short.dae", replaced(text, "'24'>0 0 0 ", "'24'>0 0 ")
    yield "index-8.dae", replaced(text, "<p>0 2 3", "<p>0 2 8")
    yield "index-minus.dae", replaced(text, "<p>0 2 3", "<p>0 2 -1")
    yield "corners.dae", replaced(text, "<p>0 2 3 ", "<p>0 2 ")
    for word in "nan", "inf", "1e400", "0,5", "x":
        yield f"array-{word}.dae", replaced(text, "'24'>0 0 0", f"'24'>0 {word} 0")
    yield "source.dae", replaced(text, "source='#p'", "source='#q'")
    yield "geometry.dae", replaced(text, "url='#g'", "url='#h'")
    yield "scene.dae", replaced(text, "url='#s'", "url='#t'")
    yield "no-scene.dae", replaced(text, "<scene><instance_visual_scene url='#s'/></scene>", "")
    yield "matrix.dae", dae_text(scene="<node><matrix>1 0 0</matrix>"
                                 "<instance_geometry url='#g'/></node>")
    yield "unit.dae", replaced(text, "meter='1'", "meter='-1'")
    cycle = "<library_nodes><node id='c'><instance_node url='#c'/></node></library_nodes>"
    yield "cycle.dae", dae_text(cycle, "<node><instance_node url='#c'/></node>")
    doubling = "".join(f"<node id='d{n + 1}'><instance_node url='#d{n}'/>"
                       f"<instance_node url='#d{n}'/></node>" for n in range(60))
    yield "doubling.dae", dae_text(f"<library_nodes><node id='d0'><instance_geometry url='#g'/>"
                                   f"</node>{doubling}</library_nodes>",
                                   "<node><instance_node url='#d60'/></node>")
    yield "latin.dae", replaced(text, "id='n'", "id='\xf6'").encode("latin-1")
    yield "blanks.dae", replaced(text, "<mesh>", "<mesh><extra>" + "<a/>" * 10 + "</extre>")


# ------------------------------------------------------------------------ 3MF

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PACKAGE = "http://schemas.openxmlformats.org/package/2006/"
TYPES = (f"<Types xmlns='{PACKAGE}content-types'><Default Extension='rels' ContentType="
         "'application/vnd.openxmlformats-package.relationships+xml'/><Default Extension='model' "
         "ContentType='application/vnd.ms-package.3dmanufacturing-3dmodel+xml'/></Types>")
ROOT = (f"<Relationships xmlns='{PACKAGE}relationships'><Relationship Target='/3D/3dmodel.model' "
        "Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>"
        "</Relationships>")


def model(more="", build="<item objectid='1'/>", head="", attributes=""):
    """The model of a cube."""
    vertices = "".join(f"<vertex x='{x}' y='{y}' z='{z}'/>" for x, y, z in CUBE)
    triangles = "".join(f"<triangle v1='{a}' v2='{b}' v3='{c}'/>" for a, b, c in FACES)
    return (f"<?xml version='1.0'?>{head}<model xmlns='{CORE}'{attributes}><resources>"
            f"<object id='1'><mesh><vertices>{vertices}</vertices><triangles>{triangles}"
            f"</triangles></mesh></object>{more}</resources><build>{build}</build></model>")


def archive(parts):
    """A zip archive of (name, bytes)."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as written:
        for name, data in parts:
            written.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return out.getvalue()


def threemf(text):
    """A 3MF of a model."""
    return archive([("[Content_Types].xml", TYPES), ("_rels/.rels", ROOT),
                    ("3D/3dmodel.model", text)])


def bomb():
    """A 3MF whose model has BOMB blanks; packed by parts, as that is faster."""
    text = model()
    at = text.index("<resources>")
    head, tail = text[:at].encode(), text[at:].encode()
    block = b" " * 2 ** 20
    packed, crc = b"", 0
    for part, times in (head, 1), (block, BOMB // len(block)), (tail, 1):
        packer = zlib.compressobj(9, zlib.DEFLATED, -15)
        packed += (packer.compress(part) + packer.flush(zlib.Z_FULL_FLUSH)) * times
        for _ in range(times):
            crc = zlib.crc32(part, crc)
    packed += zlib.compressobj(9, zlib.DEFLATED, -15).flush()
    size = len(head) + BOMB + len(tail)
    data = archive([("[Content_Types].xml", TYPES), ("_rels/.rels", ROOT)])
    end = data.rindex(b"PK\5\6")
    start = struct.unpack("<I", data[end + 16:end + 20])[0]
    name = b"3D/3dmodel.model"
    both = struct.pack("<HHHHHIIIHH", 20, 0, 8, 0, 33, crc, len(packed), size, len(name), 0)
    local = b"PK\3\4" + both + name + packed
    central = b"PK\1\2" + struct.pack("<H", 20) + both + struct.pack("<HHHII", 0, 0, 0, 0, start)
    directory = data[start:end] + central + name
    return data[:start] + local + directory + b"PK\5\6" + struct.pack(
        "<HHHHIIH", 0, 0, 3, 3, len(directory), start + len(local), 0)


def threemfs():
    """Damaged 3MF files."""
    text = model()
    sound = threemf(text)
    yield "empty.3mf", b""
    yield "garbage.3mf", b"PK\3\4" + bytes(n * n * 37 % 251 for n in range(5000))
    yield "cut.3mf", sound[:len(sound) // 2]
    yield "end-cut.3mf", sound[:-10]
    yield "no-parts.3mf", archive([])
    yield "no-model.3mf", archive([("[Content_Types].xml", TYPES), ("_rels/.rels", ROOT)])
    yield "no-rels.3mf", archive([("[Content_Types].xml", TYPES), ("3D/other.model", text)])
    at = sound.index(b"3D/3dmodel.model") + 60
    yield "crc.3mf", sound[:at] + bytes([sound[at] ^ 255]) + sound[at + 1:]
    yield "bomb.3mf", bomb()
    yield "model-cut.3mf", threemf(text[:len(text) // 2])
    yield "model-empty.3mf", threemf("")
    yield "laughs.3mf", threemf(model(head=replaced(LAUGHS, "DOCTYPE x", "DOCTYPE model"),
                                      build="&a9;<item objectid='1'/>"))
    yield "deep.3mf", threemf(model("<x>" * DEEP + "</x>" * DEEP))
    yield "index-8.3mf", threemf(replaced(text, "v1='0' v2='2'", "v1='0' v2='8'"))
    yield "index-minus.3mf", threemf(replaced(text, "v1='0' v2='2'", "v1='0' v2='-1'"))
    yield "no-index.3mf", threemf(replaced(text, " v3='3'", ""))
    for word in "nan", "inf", "1e400", "0,5", "":
        yield f"vertex-{word or 'empty'}.3mf", threemf(replaced(text, "x='0'", f"x='{word}'"))
    yield "cycle.3mf", threemf(model("<object id='2'><components><component objectid='2'/>"
                                     "</components></object>", "<item objectid='2'/>"))
    yield "cycle-of-two.3mf", threemf(model(
        "<object id='2'><components><component objectid='3'/></components></object>"
        "<object id='3'><components><component objectid='2'/></components></object>",
        "<item objectid='2'/>"))
    doubling = "".join(f"<object id='{n + 1}'><components><component objectid='{n}'/>"
                       f"<component objectid='{n}'/></components></object>" for n in range(1, 60))
    yield "doubling.3mf", threemf(model(doubling, "<item objectid='60'/>"))
    yield "no-object.3mf", threemf(model(build="<item objectid='7'/>"))
    yield "twice.3mf", threemf(model("<object id='1'><mesh><vertices/><triangles/></mesh>"
                                     "</object>"))
    yield "no-items.3mf", threemf(model(build=""))
    yield "extension.3mf", threemf(model(attributes=" xmlns:q='http://q' requiredextensions='q'"))
    yield "element.3mf", threemf(replaced(text, "<vertices>", "<points/><vertices>"))
    yield "transform.3mf", threemf(model(build="<item objectid='1' transform='1 0 0 0 1'/>"))
    yield "unit.3mf", threemf(model(attributes=" unit='furlong'"))
    yield "latin.3mf", threemf(text.replace("<build>", "<build><!-- \xf6 -->").encode("latin-1"))


# --------------------------------------------------------------------- robots

URDF = ("<robot name='r'><link name='a'><collision><geometry><box size='1 1 1'/></geometry>"
        "</collision></link><link name='b'><collision><geometry><box size='1 1 1'/></geometry>"
        "</collision></link><link name='c'><collision><geometry><box size='1 1 1'/></geometry>"
        "</collision></link><joint name='x' type='prismatic'><parent link='a'/><child link='b'/>"
        "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/></joint><joint name='y' type='fixed'>"
        "<parent link='b'/><child link='c'/><origin xyz='3 0 0'/></joint></robot>")


def robots():
    """Damaged URDF and SRDF files, paths, poses."""
    yield "empty.urdf", b""
    yield "cut.urdf", URDF[:len(URDF) // 2]
    yield "laughs.urdf", LAUGHS + replaced(URDF, "<link", "&a9;<link")
    yield "deep.urdf", replaced(URDF, "<joint", "<x>" * DEEP + "</x>" * DEEP + "<joint")
    yield "nan.urdf", replaced(URDF, "1 1 1", "1 nan 1")
    yield "huge.urdf", replaced(URDF, "1 1 1", "1 1e400 1")
    yield "cycle.urdf", replaced(URDF, "parent link='a'", "parent link='b'")
    yield "utf16.urdf", URDF.encode("utf-16-le")
    yield "empty.srdf", b""
    yield "cut.srdf", "<robot name='r'><disable_collisions link1='a'"
    yield "empty.csv", b""
    yield "nan.csv", "x\n0\nnan\n"
    yield "huge.csv", "x\n0\n1e400\n"
    yield "cells.csv", "x\n0\n1,2\n"
    yield "garbage.csv", bytes(n * n * 37 % 251 for n in range(5000))
    yield "empty.txt", b""
    yield "nan.txt", "1 0 0 0 1 0 0 0 1 nan 0 0\n"
    yield "cut.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n1 0 0 0 1\n"


def files():
    """(name, bytes) of all of them."""
    for group in stl, obj, ply, dae, threemfs, robots:
        for name, data in group():
            yield name, data if isinstance(data, bytes) else data.encode()
