#include "vtkHybridTransparencyPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHybridTransparencyPass);
