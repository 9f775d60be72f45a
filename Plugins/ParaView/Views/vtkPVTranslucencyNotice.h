// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 *
 * What the plugin does for views where they are made, in the process that has the user interface. After each still
 * frame the properties that tell what it took are read anew, so that panels and scripts have them.
 *
 * It says where views can't have its properties, since ParaView leaves them out in silence: those that were there
 * before it was loaded, and those of a server that has not loaded it.
 */
#ifndef vtkPVTranslucencyNotice_h
#define vtkPVTranslucencyNotice_h

#include "vtkPVTranslucencyViewsModule.h" // for the export macro

/// Looks at the views that are there, and at each that is made from now on; called when the plugin is loaded.
VTKPVTRANSLUCENCYVIEWS_EXPORT void vtkPVTranslucencyWatchViews();

#endif
