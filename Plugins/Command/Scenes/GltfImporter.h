// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's importer of glTF, with what it drops of materials, of binary files (.glb): the opacity of those that are
 * blended, and the extensions KHR_materials_transmission, _volume and _ior. An actor whose material transmits light
 * gets a transmission colour and a vtkTranslucencyMaterial.
 *
 * - Light is transmitted in the base colour, times the transmission factor; that much less is reflected diffusely.
 * - A volume whose thickness factor is above 0 absorbs between the surfaces of its mesh, whose own thickness counts.
 * With a thickness factor of 0 the walls are thin, and nothing absorbs. Back faces are drawn, which VTK culls
 * otherwise.
 * - The index of refraction, 1.5 if it is not given, says what the surface reflects, and how a volume refracts.
 * Textures of these extensions are not read, with a warning.
 */
#ifndef GltfImporter_h
#define GltfImporter_h

#include "vtkGLTFImporter.h"

class GltfImporter : public vtkGLTFImporter
{
public:
  static GltfImporter* New();
  vtkTypeMacro(GltfImporter, vtkGLTFImporter);

  GltfImporter(const GltfImporter&) = delete;
  GltfImporter& operator=(const GltfImporter&) = delete;

protected:
  GltfImporter() = default;
  ~GltfImporter() override = default;

  void ImportActors(vtkRenderer* renderer) override;
};

#endif
