// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text files that the command carries in itself.
 */
#ifndef Embedded_h
#define Embedded_h

namespace Embedded
{
extern const char* const SceneSchema;     ///< scene.schema.json
extern const char* const HistogramSchema; ///< histogram.schema.json
extern const char* const PageTemplate;    ///< page.mustache
}

#endif
