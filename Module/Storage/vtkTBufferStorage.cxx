#include "vtkTBufferStorage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTBufferStorage);
