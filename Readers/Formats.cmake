# Every mesh format of the plugin, one block each. Class lists, server-manager XML lists, tests and the
# table of formats follow from here; see CMake/CamaronFormats.cmake for the fields.

camaron_format(
  NAME        Visf
  EXTENSIONS  visf
  DESCRIPTION "Camarón Visf mesh"
  REPRESENTATION "Mesh Inspection"
  READS       "every dialect: ASCII, binary of both byte orders, all header versions"
  WRITES      "ASCII and binary"
  READER
  WRITER)

camaron_format(
  NAME        TRI
  EXTENSIONS  tri triq
  DESCRIPTION "Camarón or Cart3D triangle mesh"
  READS       "Camarón: ASCII; Cart3D: ASCII and binary of both byte orders, components and scalars"
  WRITES      "ASCII"
  READER
  WRITER)

camaron_format(
  NAME        M3D
  EXTENSIONS  m3d m2d
  DESCRIPTION "M3D mesh of mixed elements"
  READS       "M3D and M2D with codes, projections and materials"
  WRITES      "M3D and M2D with materials"
  READER
  WRITER)

camaron_format(
  NAME        PolygonOFF
  LABEL       "Polygon OFF"
  EXTENSIONS  off coff noff cnoff stoff stcoff stnoff stcnoff 4off
  DESCRIPTION "OFF polygon mesh"
  READS       "polygons with every prefix, normals, texture and colors, ASCII and binary"
  WRITES      "polygons with normals, texture and colors, ASCII and binary"
  READER
  WRITER)

camaron_format(
  NAME        MAPDL
  EXTENSIONS  cdb dat inp
  DESCRIPTION "Ansys Mechanical APDL deck"
  READS       "blocks and commands of nodes, elements, types and components, linear and quadratic"
  WRITES      "blocks of nodes, elements and components, linear and quadratic"
  READER_PROXY ANSYSMAPDLReader
  READER
  WRITER)

camaron_format(
  NAME        PolygonPLY
  EXTENSIONS  ply
  DESCRIPTION "PLY mesh with all its arrays"
  READS       "ASCII, binary of both byte orders, polygons, strips, edges, polyhedra, all properties"
  WRITES      "ASCII and binary of both byte orders, surfaces or polyhedra, with all arrays"
  READER_PROXY CamaronPolygonPLYReader
  READER
  WRITER)

camaron_format(
  NAME        TS
  EXTENSIONS  ts
  DESCRIPTION "Camarón tetrahedra or GOCAD TSurf"
  READS       "ASCII: tetrahedra of Camarón, TSurf of GOCAD with properties and parts"
  WRITES      "ASCII: tetrahedra of Camarón, TSurf of GOCAD with properties and parts"
  READER
  WRITER)

camaron_format(
  NAME        TetGen
  EXTENSIONS  ele node face edge neigh poly smesh
  DESCRIPTION "TetGen or Triangle mesh"
  READS       "all files, any ids, attributes, regions and markers, elements of second order"
  WRITES      "`.node`, `.ele` and `.face` with attributes, regions and markers, elements of second order"
  READER
  WRITER)

camaron_format(
  NAME        FluentMesh
  EXTENSIONS  msh cas
  DESCRIPTION "Ansys Fluent mesh"
  READS       "ASCII and binary, 2D and 3D, all cells, hanging nodes, zones"
  WRITES      "ASCII and binary of both precisions, 2D and 3D, all cells, zones"
  READER_PROXY ANSYSFluentMeshReader
  BASE        vtkFluentReader
  READER
  WRITER)

camaron_format(
  NAME        FluentHDF5
  LABEL       "ANSYS Fluent HDF5"
  EXTENSIONS  msh.h5 cas.h5 h5
  DESCRIPTION "Ansys Fluent mesh (HDF5)"
  READS       "meshes of Fluent Meshing and cases, 2D and 3D, all cells, hanging nodes, zones, fields of `.dat.h5`"
  WRITES      "meshes laid out as by Fluent Meshing, 2D and 3D, all cells, zones"
  READER_PROXY ANSYSFluentHDF5Reader
  REQUIRES    VTK::hdf5 VTK::zlib
  READER
  WRITER)

camaron_format(
  NAME        PolyMesh
  EXTENSIONS  foam
  DESCRIPTION "OpenFOAM polyMesh"
  WRITES      "ASCII and binary, 32 and 64-bit labels, gzip: all 3D cells, patches, zones, the selected cells as a set"
  WRITER)
